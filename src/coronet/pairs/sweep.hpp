// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sweep on the host: for every target particle i, the sum of a law over its neighbours, a pack of neighbours at a
// time, on all cores. What the law reads of j is first copied into records, one per particle, so that a neighbour costs
// one or two cache lines (pairs/records.hpp). Each row is squeezed to those inside the support, so a law never works on
// far pairs; then the law runs on full packs. The unused lanes of the last pack hold a particle far away, where W = 0.
//
// Each particle gathers its own sums and `close(i, sums)` ends it: whatever is computed per particle from the sums
// happens there, in registers. A close may write any field of particle i: the law reads of j what was copied before.

#include <algorithm>
#include <vector>

#include "coronet/core/parallel.hpp"
#include "coronet/core/simd.hpp"
#include "coronet/fields/particles.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"
#include "coronet/pairs/law.hpp"
#include "coronet/pairs/records.hpp"

namespace coronet {

namespace detail {

/// The values of particle i in every lane.
template <class... F, int D>
void spread(View<D> const& view, std::size_t i, Values<Pack<double>, D, Fields<F...>>& values, Fields<F...>) {
    auto const fill = [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k)
            component(G::of(values), k) = Pack<double>(view.template at<G>(k)[i]);
    };
    (fill(F{}), ...);
}

template <class... F, int D>
void add_values(Values<Pack<double>, D, Fields<F...>>& total, Values<Pack<double>, D, Fields<F...>> const& part) {
    ((F::of(total) += F::of(part)), ...);
}

template <class... F, int D>
Values<double, D, Fields<F...>> sum_lanes(Values<Pack<double>, D, Fields<F...>> const& packs) {
    Values<double, D, Fields<F...>> sums;
    auto const fill = [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k) component(G::of(sums), k) = sum(component(G::of(packs), k));
    };
    (fill(F{}), ...);
    return sums;
}

/// The neighbours of one particle that lie inside its support, followed by a pack of the filler.
class Near {
public:
    Near(std::size_t longest_row, std::size_t filler)
        : index_(longest_row + 2 * pack_size), filler_(static_cast<Index>(filler)) {}

    template <int D>
    void squeeze_row(double const* records, std::size_t width, std::span<Index const> row, std::size_t i,
                     double support) {
        double const* const x_i = records + i * width;
        count_ = 0;
        for (std::size_t k = 0; k < row.size(); k += pack_size) {
            Pack<double> x_j[4];
            fetch_four(records, row.data() + k, width, x_j);
            Pack<double> r2 = 0.0;
            for (int a = 0; a < D; ++a) r2 += (x_i[a] - x_j[a]) * (x_i[a] - x_j[a]);
            unsigned held = lanes_below(r2, support * support);
            if (row.size() - k < pack_size) held &= (1u << (row.size() - k)) - 1;
            squeeze(held, row.data() + k, index_.data() + count_);
            count_ += static_cast<std::size_t>(__builtin_popcount(held));
        }
        std::fill_n(index_.begin() + static_cast<std::ptrdiff_t>(count_), pack_size, filler_);
    }

    std::size_t count() const { return count_; }
    Index const* index(std::size_t k) const { return index_.data() + k; }

private:
    std::vector<Index> index_;
    Index filler_;
    std::size_t count_ = 0;
};

/// Sums a law over the neighbours of i. Kept out of line, so that instantiations can be counted by name.
template <int D, class Law>
[[gnu::noinline]] auto sweep_row(View<D> const& view, double const* records, Near const& near, std::size_t i,
                                 Kernel const& kernel, Law const& law) {
    using R = Pack<double>;
    using Reads = typename Law::reads;
    using Own = Unite<typename Law::own, Reads>;
    using Layout = RecordLayout<D, Reads>;
    Pair<R, D, Own, Reads> ij;
    spread(view, i, ij.i, Own{});
    Vector<R, D> x_i;
    for (int a = 0; a < D; ++a) x_i[a] = R(records[i * Layout::width + static_cast<std::size_t>(a)]);
    ij.h = R(kernel.support / 3);

    Values<R, D, typename Law::gives> total;
    for (std::size_t k = 0; k < near.count(); k += pack_size) {
        Vector<R, D> x_j;
        Layout::fetch(records, near.index(k), x_j, ij.j);
        ij.x = x_i - x_j;
        ij.r2 = norm2(ij.x);
        auto const [W, F] = kernel(ij.r2);
        ij.W = W;
        ij.gradW = F * ij.x;
        add_values(total, law(ij));
    }
    return sum_lanes(total);
}

}  // namespace detail

/// Sums `law` over the neighbours of each target and hands the sums, a Values<double, D, Law::gives>, to close(i,
/// sums).
template <int D, class Law, class Close>
void sweep(Particles<D> const& particles, Neighbours<D> const& neighbours, Targets const& targets, Kernel const& kernel,
           Law const& law, Close const& close) {
    using Layout = RecordLayout<D, typename Law::reads>;
    auto const view = particles.view();
    std::size_t const n = particles.size();
    double* const records = particles.scratch((n + 1) * Layout::width);
    for_ranges(n, [&](std::size_t first, std::size_t last) { Layout::fill(view, first, last, records); });
    Layout::fill_filler(n, records);
    for_blocks(targets.blocks(), [&](std::size_t block) {
        detail::Near near(neighbours.longest_row(), n);
        for (std::size_t k = targets.begin[block]; k < targets.begin[block + 1]; ++k) {
            std::size_t const i = targets[k];
            near.squeeze_row<D>(records, Layout::width, neighbours.row(i), i, kernel.support);
            close(i, detail::sweep_row(view, records, near, i, kernel, law));
        }
    });
}

/// The same, storing the sums in the fields the law gives.
template <int D, class Law>
void sweep(Particles<D> const& particles, Neighbours<D> const& neighbours, Kernel const& kernel, Law const& law) {
    auto const view = particles.view();
    sweep(particles, neighbours, neighbours.all(), kernel, law, [&](std::size_t i, auto const& sums) {
        for_fields(typename Law::gives{}, [&]<class F>(F) { view.template set<F>(i, F::of(sums)); });
    });
}

}  // namespace coronet
