// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Smoothing kernels W(r) with support H (W = 0 for r >= H), as data: with s = r/H, every kernel here is a sum over
// knots
//     W(r) = sum_k u_k^3 (c_k0 + c_k1 u_k + c_k2 u_k^2 + c_k3 u_k^3),   u_k = max(0, knot_k - s),
// so one branch-free piece of code serves all, and W and its slope vanish at the edge by themselves. Kernels of several
// knots are splines: of each knot's powers they have the odd ones alone, c_k1 = c_k3 = 0.
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
    double support;  ///< H [m]
    /// Distances are taken in units of a power of two near H, so that roots are of numbers near one and no digit is
    /// lost.
    double per_unit2;  ///< 1/unit^2 [1/m^2]
    double unit_over_support;
    int knots;
    double knot[most_knots];
    double c[most_knots][4];  ///< in 1/m^D: the normalisation is folded in
    double d[most_knots][4];  ///< in 1/m^(D+2): F = unit/r sum_k u_k^2 (d_k0 + ...), d_kn = -(n + 3) c_kn/(H unit)

    /// r2 = r^2 [m^2]. At r = 0 F is finite for every kernel but `w3`, whose limit is infinite: there F is large and
    /// F (x_i - x_j) still zero.
    template <class R>
    CORONET_HD KernelValue<R> operator()(R const& r2) const {
        return evaluate(r2, knots);
    }
    /// The same where the number of knots is known when it is compiled; those above `knots` add nothing.
    template <int known_knots, class R>
    CORONET_HD KernelValue<R> at(R const& r2) const {
        return evaluate(r2, std::integral_constant<int, known_knots>{});
    }

    /// W at r = 0: what a particle adds to its own sums.
    double at_zero() const { return (*this)(0.0).W; }

private:
    template <class R, class Count>
    CORONET_HD KernelValue<R> evaluate(R const& r2, Count count) const {
        R const safe = largest(r2 * R(per_unit2), R(nearest_square<R>));
        R const inverse_r = inverse_root(safe);
        R const s = safe * inverse_r * R(unit_over_support);
        R W = R(0), slope = R(0);
        for (int k = 0; k < count; ++k) {
            R const u = largest(R(knot[k]) - s, R(0));
            R const u2 = u * u;
            R const even = R(c[k][0]) + u2 * R(c[k][2]), even_slope = R(d[k][0]) + u2 * R(d[k][2]);
            if (count == 1) {
                W += u2 * u * (even + u * (R(c[k][1]) + u2 * R(c[k][3])));
                slope += u2 * (even_slope + u * (R(d[k][1]) + u2 * R(d[k][3])));
            } else {
                W += u2 * u * even;
                slope += u2 * even_slope;
            }
        }
        return {W, slope * inverse_r};
    }
};

/// The names that make_kernel knows.
std::span<std::string_view const> kernel_names();

/// A kernel by name, of the given support radius [m], normalised in `dimension` = 1, 2 or 3 dimensions.
/// Throws std::invalid_argument for a name that is not among kernel_names().
Kernel make_kernel(std::string_view name, int dimension, double support);

}  // namespace coronet
