// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which points a case's shapes hold. A point on the boundary is inside: the papers keep lattice points with r <= R.

#include <cmath>
#include <numbers>

#include "coronet/cases/case.hpp"
#include "coronet/core/tensor.hpp"

namespace coronet {

/// x turned by an angle [degrees] in the x-y plane.
template <int D>
Vector<double, D> turned(Vector<double, D> const& x, double degrees) {
    double const c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    auto y = x;
    y[0] = c * x[0] - s * x[1];
    y[1] = s * x[0] + c * x[1];
    return y;
}

/// Whether x [m] is inside; `slack` [m] keeps points that round-off would put just outside.
template <int D>
bool holds(Shape const& shape, Vector<double, D> const& x, double slack) {
    Vector<double, D> from_centre;
    for (int k = 0; k < D; ++k) from_centre[k] = x[k] - shape.centre[k];
    auto const y = turned(from_centre, -shape.rotation);

    bool inside = true;
    if (shape.kind == "disc" || shape.kind == "ball") {
        inside = norm2(y) <= (shape.radius + slack) * (shape.radius + slack);
    } else if (shape.kind == "box") {
        for (int k = 0; k < D; ++k) inside = inside && std::fabs(y[k]) <= shape.size[k] / 2 + slack;
    } else {
        double q = 0;
        for (int k = 0; k < D; ++k) q += std::pow(y[k] / (shape.semi_axes[k] + slack), 2);
        inside = q <= 1;
    }
    for (Cut const& cut : shape.cuts) {
        double beyond = 0, length2 = 0;
        for (int k = 0; k < D; ++k) {
            beyond += (x[k] - cut.point[k]) * cut.normal[k];
            length2 += cut.normal[k] * cut.normal[k];
        }
        inside = inside && beyond <= slack * std::sqrt(length2);
    }
    return inside;
}

/// The radius of a ball around the centre that holds the shape [m].
inline double reach(Shape const& shape) {
    if (shape.kind == "disc" || shape.kind == "ball") return shape.radius;
    double r2 = 0;
    for (double const edge : shape.kind == "box" ? shape.size : shape.semi_axes)
        r2 = shape.kind == "box" ? r2 + edge * edge / 4 : std::max(r2, edge * edge);
    return std::sqrt(r2);
}

}  // namespace coronet
