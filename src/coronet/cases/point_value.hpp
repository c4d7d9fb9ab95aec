// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The value of a field at a point: the mean over the liquid in the kernel's support, images included, weighted with V W
// (Shepard), or what is exact for a linear field: that mean, taken from the centre of the weights to the point along
// the corrected gradient (terms/gradient_correction.hpp). Zero where there is no liquid.

#include "coronet/cases/case.hpp"
#include "coronet/fields/particles.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/terms/gradient_correction.hpp"

namespace coronet {

template <int D>
Kernel probe_kernel(Case const& c) {
    return make_kernel(c.method.kernel, D, c.method.support * c.particles.spacing);
}

/// The sum of part(i, x_i - at) over the liquid within the support.
template <int D, class T, class Part>
T sum_around(Particles<D> const& particles, Kernel const& kernel, Vector<double, D> const& at, T const& zero,
             Part const& part) {
    auto const view = particles.view();
    std::size_t const own = particles.owned(), images = particles.begin(Role::liquid_image);
    return sum_over(own + particles.count(Role::liquid_image), zero, [&](std::size_t k) {
        std::size_t const i = k < own ? k : k - own + images;
        auto const x = view.template get<Position>(i) - at;
        return norm2(x) < kernel.support * kernel.support ? part(i, x) : zero;
    });
}

template <int D, class Value>
double value_at(Particles<D> const& particles, Kernel const& kernel, Vector<double, D> const& at, Value const& value) {
    auto const view = particles.view();
    auto const sums = sum_around(particles, kernel, at, Vector<double, 2>{}, [&](std::size_t i, auto const& x) {
        double const weight = view.template get<Volume>(i) * kernel(norm2(x)).W;
        return Vector<double, 2>{{weight, weight * value(i)}};
    });
    return sums[0] > 0 ? sums[1] / sums[0] : 0;
}

template <int D, class Value>
double linear_value_at(Particles<D> const& particles, Kernel const& kernel, Vector<double, D> const& at,
                       Value const& value) {
    struct Sums {
        double W0 = 0, f0 = 0;
        Vector<double, D> W1, G0, f_slope;
        Symmetric<double, D> G1;

        Sums operator+(Sums const& b) const {
            return {W0 + b.W0, f0 + b.f0, W1 + b.W1, G0 + b.G0, f_slope + b.f_slope, G1 + b.G1};
        }
    };
    auto const view = particles.view();
    auto const sums = sum_around(particles, kernel, at, Sums{}, [&](std::size_t i, Vector<double, D> const& x) {
        auto const [W, F] = kernel(norm2(x));
        double const V = view.template get<Volume>(i), f = value(i);
        Vector<double, D> const VgradW = (-V * F) * x;
        return Sums{V * W, V * W * f, (V * W) * x, VgradW, f * VgradW, outer_of_parallels(VgradW, x)};
    });
    if (!(sums.W0 > 0)) return 0;
    double const mean = sums.f0 / sums.W0;
    GradientCorrection<double, D> const correction(sums.W0, sums.W1, sums.G0, sums.G1);
    if (correction.fell_back != 0) return mean;
    return mean - dot(correction.gradient(sums.f_slope, sums.f0), sums.W1) / sums.W0;
}

}  // namespace coronet
