// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The value of a field at a point: the mean over the particles in the kernel's support, weighted with V W (Shepard).
// Zero where there is no liquid.

#include "coronet/cases/case.hpp"
#include "coronet/fields/particles.hpp"
#include "coronet/kernels/kernel.hpp"

namespace coronet {

template <int D>
Kernel probe_kernel(Case const& c) {
    return make_kernel(c.method.kernel, D, c.method.support * c.particles.spacing);
}

template <int D, class Value>
double value_at(Particles<D> const& particles, Kernel const& kernel, Vector<double, D> const& at, Value const& value) {
    auto const view = particles.view();
    auto const sums = sum_over(particles.owned(), Vector<double, 2>{}, [&](std::size_t i) {
        double const r2 = norm2(view.template get<Position>(i) - at);
        if (r2 >= kernel.support * kernel.support) return Vector<double, 2>{};
        double const weight = view.template get<Volume>(i) * kernel(r2).W;
        return Vector<double, 2>{{weight, weight * value(i)}};
    });
    return sums[0] > 0 ? sums[1] / sums[0] : 0;
}

}  // namespace coronet
