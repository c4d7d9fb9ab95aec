// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/column_mode.hpp"

#include "coronet/cases/bessel_ratio.hpp"

namespace coronet {

double column_growth_rate(double k, double R, double rho, double sigma, double mu) {
    double const rate = std::sqrt(sigma / (rho * R * R * R)), nu = mu / std::sqrt(rho * sigma * R), k2 = k * R * k * R;
    double const q = bessel_ratio(0, k2), inviscid = std::sqrt((1 - k2) * q);
    auto const g = [](double z2) { return 1 + bessel_ratio(1, z2); };
    if (nu < 1e-8) return inviscid * rate;
    double low = 0, high = inviscid;  // viscosity slows it
    while (high - low > 1e-15 * inviscid) {
        double const s = (low + high) / 2, l2 = k2 + s / nu;
        if (s == low || s == high) break;
        bool const above =
            s * s + 2 * nu * s * q * (g(k2) - 2 * k2 / (k2 + l2) * g(l2)) > (1 - k2) * q * (l2 - k2) / (l2 + k2);
        (above ? high : low) = s;
    }
    return high * rate;
}

}  // namespace coronet
