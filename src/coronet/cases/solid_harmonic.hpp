// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The solid harmonic of degree n that is symmetric about the x axis, theta the angle from it: in 2D r^n cos(n theta),
// in 3D r^n P_n(cos theta), P_n Legendre's polynomial. Its gradient is the flow of mode n in a drop without viscosity;
// and its mean over a ball about x is its value at x.
//
// In 3D, with S_n = r^n P_n, (n + 1) S_(n+1) = (2n + 1) x S_n - n r^2 S_(n-1), dS_n/dx = n S_(n-1), and at right angles
// to the axis, by P'_(n-1) = sum_k (2k + 1) P_k over k = n - 2, n - 4, ...,
//     dS_n/dy = -y sum_k (2k + 1) r^(n-2-k) S_k.

#include <cmath>
#include <complex>
#include <vector>

#include "coronet/core/tensor.hpp"

namespace coronet {

template <int D>
struct SolidHarmonic {
    double value;
    Vector<double, D> gradient;
};

inline SolidHarmonic<2> solid_harmonic(int n, Vector<double, 2> const& x) {
    std::complex<double> const z(x[0], x[1]);
    auto const below = std::pow(z, n - 1);
    return {(below * z).real(), {{n * below.real(), -n * below.imag()}}};
}

inline SolidHarmonic<3> solid_harmonic(int n, Vector<double, 3> const& x) {
    double const r2 = norm2(x);
    std::vector<double> S{1, x[0]};
    for (int k = 1; k < n; ++k)
        S.push_back(
            ((2 * k + 1) * x[0] * S[static_cast<std::size_t>(k)] - k * r2 * S[static_cast<std::size_t>(k - 1)]) /
            (k + 1));
    double across = 0;
    for (int k = n - 2; k >= 0; k -= 2)
        across -= (2 * k + 1) * std::pow(r2, (n - 2 - k) / 2) * S[static_cast<std::size_t>(k)];
    auto const top = static_cast<std::size_t>(n);
    return {S[top], {{n * S[top - 1], across * x[1], across * x[2]}}};
}

}  // namespace coronet
