// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// z I_{n+1}(z)/I_n(z) of modified Bessel functions, for real or complex z^2, by its continued fraction
//     z^2/(2 (n + 1) + z^2/(2 (n + 2) + ...)),
// from far enough out. The functions themselves overflow where viscosity is small.

#include <cmath>

namespace coronet {

template <class Number>
Number bessel_ratio(double n, Number const& z2) {
    Number tail = 0;
    for (int k = 60 + static_cast<int>(2 * std::sqrt(std::abs(z2))); k > 0; --k) tail = z2 / (2 * (n + k) + tail);
    return tail;
}

}  // namespace coronet
