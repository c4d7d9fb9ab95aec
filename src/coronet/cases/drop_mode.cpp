// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_mode.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "coronet/cases/bessel_ratio.hpp"

namespace coronet {

namespace {

using Complex = std::complex<double>;

double inviscid_frequency(int dimension, int n) {
    return std::sqrt(dimension == 2 ? n * (n * n - 1.0) : n * (n - 1.0) * (n + 2.0));
}

/// What vanishes for a normal mode s.
Complex characteristic(int dimension, int n, double nu, Complex const& s) {
    double const w = inviscid_frequency(dimension, n), w2 = w * w, m = n - 1;
    Complex const z2 = s / nu, zK = bessel_ratio(dimension == 2 ? n : n + 0.5, z2);
    if (dimension == 3) {
        Complex const C = -2 * m / (z2 + 2.0 * (n * n - 1) - 2.0 * zK);
        return s * s + 2 * nu * s * (n * m + n * (n + 1.0) * C * (zK + m)) + w2 * (1.0 + (n + 1.0) * C);
    }
    Complex const C = -2 * n * m / (z2 + 2 * n * m - 2.0 * zK);
    return s * s + 2 * nu * n * s * (m + C * (zK + m)) + w2 * (1.0 + C);
}

/// By secants from two guesses.
Complex root(int dimension, int n, double nu, Complex before, Complex s) {
    Complex f_before = characteristic(dimension, n, nu, before);
    for (int k = 0; k < 50 && std::abs(s - before) > 1e-14 * std::abs(s); ++k) {
        Complex const f = characteristic(dimension, n, nu, s);
        if (f == f_before) break;
        Complex const better = s - f * (s - before) / (f - f_before);
        before = s;
        f_before = f;
        s = better;
    }
    return s;
}

}  // namespace

std::optional<DropMode> drop_mode(int dimension, int n, double R, double rho, double sigma, double mu) {
    double const rate = std::sqrt(sigma / (rho * R * R * R)), nu = mu / std::sqrt(rho * sigma * R);
    double const w = inviscid_frequency(dimension, n), m = dimension == 2 ? 2 * n * (n - 1.0) : (n - 1) * (2 * n + 1.0);
    // Followed from a viscosity so small that the limit is a good guess, to the one that is asked for.
    double now = std::min(nu, 1e-3 / n);
    if (now < 1e-6 / n) return DropMode{w * rate, m * nu * rate};  // to 1e-5 of the frequency
    Complex s = root(dimension, n, now, {-0.9 * m * now, w}, {-m * now, w});
    while (now < nu) {
        double const next = std::min(nu, 1.05 * now);
        s = root(dimension, n, next, s, s * Complex(1, 1e-3));
        now = next;
        if (!(s.imag() > 1e-6 * w)) return {};
    }
    return DropMode{s.imag() * rate, -s.real() * rate};
}

}  // namespace coronet
