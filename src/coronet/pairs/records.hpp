// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Records: what a law reads of a neighbour, packed together. A particle's position and the fields of the list stand
// side by side, padded to whole groups of four numbers, so that a neighbour is fetched by a few wide loads from one or
// two cache lines instead of one gather per number from as many arrays.

#include "coronet/core/simd.hpp"
#include "coronet/fields/particles.hpp"

namespace coronet {

template <int D, class List>
struct RecordLayout;

template <int D, class... F>
struct RecordLayout<D, Fields<F...>> {
    static constexpr int used = D + (0 + ... + components<F::rank, D>());
    static constexpr std::size_t width = static_cast<std::size_t>((used + 3) / 4 * 4);

    /// Copies particles [first, last) into their records.
    static void fill(View<D> const& view, std::size_t first, std::size_t last, double* records) {
        double const* from[used];
        double const** next = from;
        for (int k = 0; k < D; ++k) *next++ = view.template at<Position>(k);
        auto const add = [&]<class G>(G) {
            for (int k = 0; k < components<G::rank, D>(); ++k) *next++ = view.template at<G>(k);
        };
        (add(F{}), ...);
        for (std::size_t i = first; i < last; ++i)
            for (std::size_t k = 0; k < used; ++k) records[i * width + k] = from[k][i];
    }

    /// Record n, behind those of n particles, fills the unused lanes of a pack: like the first particle (so that no law
    /// divides by zero), but farther away than any support.
    static void fill_filler(std::size_t n, double* records) {
        for (std::size_t k = 0; k < width && n > 0; ++k) records[n * width + k] = k < D ? 1e30 : records[k];
    }

    /// Positions and values of the particles at index[0], index[1], ..., a lane each.
    static void fetch(double const* records, Index const* index, Vector<Pack<double>, D>& x,
                      Values<Pack<double>, D, Fields<F...>>& values) {
        Pack<double> number[width];
        for (std::size_t k = 0; k < width; k += 4) fetch_four(records + k, index, width, number + k);
        Pack<double> const* next = number;
        for (int k = 0; k < D; ++k) x[k] = *next++;
        auto const take = [&]<class G>(G) {
            for (int k = 0; k < components<G::rank, D>(); ++k) component(G::of(values), k) = *next++;
        };
        (take(F{}), ...);
    }
};

}  // namespace coronet
