// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sweep on a GPU: the same laws and closes as on the host (pairs/sweep.hpp), one thread a particle, one neighbour
// at a time. The loop itself is Thrust's.

#include <thrust/execution_policy.h>
#include <thrust/for_each.h>
#include <thrust/iterator/counting_iterator.h>

#include "coronet/fields/particles.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/pairs/law.hpp"

namespace coronet {

/// Neighbour rows in device memory: those of particle i are index[begin[i]] ... index[begin[i + 1] - 1].
struct DeviceRows {
    std::size_t const* begin;
    Index const* index;
};

/// A particle as a close sees it (pairs/close.hpp).
template <int D>
struct OneParticle {
    using Number = double;
    static constexpr int dimension = D;
    View<D> view;
    std::size_t i;

    template <class F>
    CORONET_HD ValueOf<F, double, D> get() const {
        return view.template get<F>(i);
    }
    template <class F>
    CORONET_HD void set(ValueOf<F, double, D> const& value) const {
        view.template set<F>(i, value);
    }
};

namespace detail {

template <int D, class... F>
CORONET_HD Values<double, D, Fields<F...>> read_values(View<D> const& view, std::size_t i, Fields<F...>) {
    Values<double, D, Fields<F...>> values;
    ((F::of(values) = view.template get<F>(i)), ...);
    return values;
}

template <int D, class... F>
CORONET_HD void add_values(Values<double, D, Fields<F...>>& total, Values<double, D, Fields<F...>> const& part) {
    ((F::of(total) += F::of(part)), ...);
}

template <int D, class Law, class Close>
struct DeviceRowSum {
    View<D> view;
    DeviceRows rows;
    Kernel kernel;
    Law law;
    Close close;

    CORONET_HD void operator()(std::size_t i) const {
        using Own = Unite<typename Law::own, typename Law::reads>;
        Pair<double, D, Own, typename Law::reads> ij;
        ij.i = read_values(view, i, Own{});
        ij.h = kernel.support / 3;
        auto const x_i = view.template get<Position>(i);
        Values<double, D, typename Law::gives> total;
        for (std::size_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k) {
            std::size_t const j = static_cast<std::size_t>(rows.index[k]);
            ij.x = x_i - view.template get<Position>(j);
            ij.r2 = norm2(ij.x);
            if (ij.r2 >= kernel.support * kernel.support) continue;
            ij.j = read_values(view, j, typename Law::reads{});
            auto const value = kernel(ij.r2);
            ij.W = value.W;
            ij.F = value.F;
            ij.gradW = value.F * ij.x;
            add_values(total, law(ij));
        }
        close(OneParticle<D>{view, i}, total);
    }
};

}  // namespace detail

/// Sums `law` over the neighbours of each of `count` particles, all in device memory, and ends each with close(at,
/// sums).
template <int D, class Law, class Close>
void sweep_on_device(View<D> const& view, DeviceRows rows, std::size_t count, Kernel const& kernel, Law const& law,
                     Close const& close) {
    thrust::for_each_n(thrust::device, thrust::counting_iterator<std::size_t>(0), count,
                       detail::DeviceRowSum<D, Law, Close>{view, rows, kernel, law, close});
}

}  // namespace coronet
