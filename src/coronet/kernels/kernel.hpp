// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Smoothing kernels W(r) with support H (W = 0 for r >= H), as data: with s = r/H, every kernel here is a sum over
// knots
//     W(r) = sum_k u_k^3 (c_k0 + c_k1 u_k + c_k2 u_k^2 + c_k3 u_k^3),   u_k = max(0, knot_k - s),
// so W and its slope vanish at the edge by themselves, without a branch. There are two kinds. A polynomial has one knot
// and no slope at r = 0, so that W'/r is a polynomial, too. What has several knots, or a slope at r = 0, counts as a
// spline: all of its knots have the same power alone, u^3 or u^5. Then W is the sum of the terms of its slope, each
// times u, and times a number that is the same for all.
//
// Units: W in 1/m^D. Sources of the shapes stand beside their names in kernel.cpp.

#include <span>
#include <string_view>
#include <type_traits>

#include "coronet/core/real.hpp"

namespace coronet {

/// W and F = W'/r at a distance; the gradient of W at x_i is F (x_i - x_j). F is in 1/m^(D+2).
template <class R>
struct KernelValue {
    R W, F;
};

struct Kernel {
    static constexpr int most_knots = 3;
    double support;      ///< H [m]
    double per_support;  ///< 1/H [1/m]
    bool is_polynomial;
    double c_over_d;  ///< of a spline: the same for all of its coefficients, -H/(n + 3) [m]
    int knots;
    double knot[most_knots];
    double c[most_knots][4];  ///< in 1/m^D: the normalisation is folded in
    /// Of a spline F = 1/r sum_k u_k^2 (d_k0 + d_k2 u_k^2), d_kn = -(n + 3) c_kn/H, in 1/m^(D+1). Of a polynomial F =
    /// u^2 (d_00 + d_01 u + d_02 u^2), in 1/m^(D+2), which is the same with r taken out of the sum.
    double d[most_knots][4];

    /// r2 = r^2 [m^2]. At r = 0 F is finite for every kernel but `w3`, whose limit is infinite: there F is large and
    /// F (x_i - x_j) still zero.
    template <class R>
    CORONET_HD KernelValue<R> operator()(R const& r2) const {
        return is_polynomial ? polynomial(r2) : spline(r2, knots);
    }
    /// The same where it is known when it is compiled which kind it is; knots above `knots` add nothing.
    template <bool known_polynomial, class R>
    CORONET_HD KernelValue<R> at(R const& r2) const {
        if constexpr (known_polynomial) return polynomial(r2);
        else return spline(r2, std::integral_constant<int, most_knots>{});
    }

    /// W at r = 0: what a particle adds to its own sums.
    double at_zero() const { return (*this)(0.0).W; }

private:
    template <class R>
    CORONET_HD auto roots_of(R const& r2) const {
        return roots(largest(r2, R(nearest_square<R> * support * support)));
    }
    template <class R>
    CORONET_HD KernelValue<R> polynomial(R const& r2) const {
        R const u = largest(R(knot[0]) - roots_of(r2).root * R(per_support), R(0));
        R const u2 = u * u;
        return {u2 * u * (R(c[0][0]) + u2 * R(c[0][2]) + u * (R(c[0][1]) + u2 * R(c[0][3]))),
                u2 * (R(d[0][0]) + u2 * R(d[0][2]) + u * R(d[0][1]))};
    }
    template <class R, class Count>
    CORONET_HD KernelValue<R> spline(R const& r2, Count count) const {
        auto const [r, per_r] = roots_of(r2);
        R const s = r * R(per_support);
        R sum = R(0), slope = R(0);
        for (int k = 0; k < count; ++k) {
            R const u = largest(R(knot[k]) - s, R(0));
            R const u2 = u * u, part = u2 * (R(d[k][0]) + u2 * R(d[k][2]));
            slope += part;
            sum += part * u;
        }
        return {R(c_over_d) * sum, slope * per_r};
    }
};

/// The names that make_kernel knows.
std::span<std::string_view const> kernel_names();

/// A kernel by name, of the given support radius [m], normalised in `dimension` = 1, 2 or 3 dimensions.
/// Throws std::invalid_argument for a name that is not among kernel_names().
Kernel make_kernel(std::string_view name, int dimension, double support);

}  // namespace coronet
