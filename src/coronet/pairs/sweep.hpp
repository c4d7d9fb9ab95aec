// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sweep on the host: for every target particle i, the sum of a law over its neighbours, a pack of neighbours at a
// time, on all cores. First the row is squeezed to those inside the support, so a law never works on far pairs; then the
// law runs on full packs. The unused lanes of the last pack hold i itself at the edge of the support, where W = 0.
//
// Each particle gathers its own sums and `close(i, sums)` ends it: whatever is computed per particle from the sums happens
// there, in registers. A close writes fields of particle i alone, and none that the law reads of j.

#include <algorithm>
#include <vector>

#include "coronet/core/parallel.hpp"
#include "coronet/core/simd.hpp"
#include "coronet/fields/particles.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/neighbours.hpp"
#include "coronet/pairs/law.hpp"

namespace coronet {

namespace detail {

template <class... F, int D>
Values<Pack<double>, D, Fields<F...>> gather_values(View<D> const& view, Index const* index, Fields<F...>) {
    Values<Pack<double>, D, Fields<F...>> values;
    auto const fill = [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k)
            component(G::of(values), k) = gather(view.template at<G>(k), index);
    };
    (fill(F{}), ...);
    return values;
}

template <class... F, int D>
Values<Pack<double>, D, Fields<F...>> spread_values(View<D> const& view, std::size_t i, Fields<F...>) {
    Values<Pack<double>, D, Fields<F...>> values;
    auto const fill = [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k)
            component(G::of(values), k) = Pack<double>(view.template at<G>(k)[i]);
    };
    (fill(F{}), ...);
    return values;
}

template <class... F, int D>
void add_values(Values<Pack<double>, D, Fields<F...>>& total, Values<Pack<double>, D, Fields<F...>> const& part) {
    ((F::of(total) += F::of(part)), ...);
}

template <class... F, int D>
Values<double, D, Fields<F...>> sum_lanes(Values<Pack<double>, D, Fields<F...>> const& packs) {
    Values<double, D, Fields<F...>> sums;
    auto const fill = [&]<class G>(G) {
        for (int k = 0; k < components<G::rank, D>(); ++k)
            component(G::of(sums), k) = sum(component(G::of(packs), k));
    };
    (fill(F{}), ...);
    return sums;
}

/// The neighbours of one particle that lie inside its support: what squeezing a row leaves, ready for full packs.
template <int D>
class Near {
public:
    explicit Near(std::size_t longest_row) : room_(longest_row + 2 * pack_size), index_(room_), number_(room_ * (D + 1)) {}

    void squeeze_row(View<D> const& view, std::span<Index const> row, Index i, Kernel const& kernel) {
        auto const x_i = view.template get<Position>(static_cast<std::size_t>(i));
        double const H2 = kernel.support * kernel.support;
        count_ = 0;
        for (std::size_t k = 0; k < row.size(); k += pack_size) {
            Index const* const index = row.data() + k;
            Vector<Pack<double>, D> x;
            for (int a = 0; a < D; ++a) x[a] = x_i[a] - gather(view.template at<Position>(a), index);
            Pack<double> const r2 = norm2(x);
            unsigned held = lanes_below(r2, H2);
            if (row.size() - k < pack_size) held &= (1u << (row.size() - k)) - 1;
            squeeze(held, index, index_.data() + count_);
            for (int a = 0; a < D; ++a) squeeze(held, x[a], number_.data() + a * room_ + count_);
            squeeze(held, r2, number_.data() + D * room_ + count_);
            count_ += static_cast<std::size_t>(__builtin_popcount(held));
        }
        for (std::size_t k = count_; k < count_ + pack_size; ++k) {
            index_[k] = i;
            for (int a = 0; a < D; ++a) number_[a * room_ + k] = a == 0 ? kernel.support : 0.0;
            number_[D * room_ + k] = H2;
        }
    }

    std::size_t count() const { return count_; }
    Index const* index(std::size_t k) const { return index_.data() + k; }
    Pack<double> r2(std::size_t k) const { return load(number_.data() + D * room_ + k); }
    Vector<Pack<double>, D> x(std::size_t k) const {
        Vector<Pack<double>, D> x;
        for (int a = 0; a < D; ++a) x[a] = load(number_.data() + a * room_ + k);
        return x;
    }

private:
    std::size_t room_, count_ = 0;
    std::vector<Index> index_;
    std::vector<double> number_;
};

/// Sums a law over the neighbours of i. Kept out of line, so that instantiations can be counted by name.
template <int D, class Law>
[[gnu::noinline]] auto sweep_row(View<D> const& view, Near<D> const& near, std::size_t i, Kernel const& kernel,
                                 Law const& law) {
    using R = Pack<double>;
    using Own = Unite<typename Law::own, typename Law::reads>;
    using Reads = typename Law::reads;
    Pair<R, D, Own, Reads> ij;
    ij.i = spread_values(view, i, Own{});
    ij.h = R(kernel.support / 3);
    Values<R, D, typename Law::gives> total;
    for (std::size_t k = 0; k < near.count(); k += pack_size) {
        ij.j = gather_values(view, near.index(k), Reads{});
        ij.x = near.x(k);
        ij.r2 = near.r2(k);
        auto const [W, F] = kernel(ij.r2);
        ij.W = W;
        ij.gradW = F * ij.x;
        add_values(total, law(ij));
    }
    return sum_lanes(total);
}

}  // namespace detail

/// Sums `law` over the neighbours of each target and hands the sums, a Values<double, D, Law::gives>, to close(i, sums).
template <int D, class Law, class Close>
void sweep(Particles<D> const& particles, Neighbours<D> const& neighbours, Targets const& targets, Kernel const& kernel,
           Law const& law, Close const& close) {
    auto const view = particles.view();
    for_blocks(targets.blocks(), [&](std::size_t block) {
        detail::Near<D> near(neighbours.longest_row());
        for (std::size_t k = targets.begin[block]; k < targets.begin[block + 1]; ++k) {
            std::size_t const i = targets[k];
            near.squeeze_row(view, neighbours.row(i), static_cast<Index>(i), kernel);
            close(i, detail::sweep_row(view, near, i, kernel, law));
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
