// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The tangents t of a unit vector n: with them as the first axes and n as the last, a right-handed frame.

#include <algorithm>
#include <array>
#include <cmath>

#include "coronet/core/tensor.hpp"

namespace coronet {

inline std::array<Vector<double, 2>, 1> tangents(Vector<double, 2> const& n) { return {{{{n[1], -n[0]}}}}; }

/// The first one is also at right angles to the axis of space that n is farthest from.
inline std::array<Vector<double, 3>, 2> tangents(Vector<double, 3> const& n) {
    double const size[3] = {std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2])};
    auto const k0 = static_cast<int>(std::min_element(size, size + 3) - size), k1 = (k0 + 1) % 3, k2 = (k0 + 2) % 3;
    double const inverse = 1 / std::sqrt(n[k1] * n[k1] + n[k2] * n[k2]);
    Vector<double, 3> a, b;
    a[k1] = inverse * n[k2];
    a[k2] = -inverse * n[k1];
    b[k0] = n[k1] * a[k2] - n[k2] * a[k1];
    b[k1] = -n[k0] * a[k2];
    b[k2] = n[k0] * a[k1];
    return {a, b};
}

}  // namespace coronet
