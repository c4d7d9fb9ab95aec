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

/// The radius [m] of a shape of kind drop in the direction of x, at the angle theta from the first axis: R0 (1 + a cos
/// n theta), its area that of the disc of the shape's radius, R0^2 (1 + a^2/2).
inline double drop_radius(Shape const& shape, Vector<double, 2> const& x) {
    double const a = shape.amplitude;
    return shape.radius / std::sqrt(1 + a * a / 2) * (1 + a * std::cos(shape.mode * std::atan2(x[1], x[0])));
}
/// In 3D R0 (1 + a P_n(cos theta)), its volume that of the ball: over R0^3, 1 + 3 a^2 <P^2> + a^3 <P^3>, with the means
/// of the Legendre polynomial P_n over the sphere, <P^2> = 1/(2n + 1) and <P^3>, for even n the square of Wigner's
/// symbol (n n n; 0 0 0), (3n/2)!^2/((n/2)!)^6 (n!)^3/(3n + 1)!.
inline double drop_radius(Shape const& shape, Vector<double, 3> const& x) {
    double const a = shape.amplitude, n = shape.mode, r = std::sqrt(norm2(x));
    auto const log_of_factorial = [](double k) { return std::lgamma(k + 1); };
    double const cubes = shape.mode % 2 == 1 ? 0
                                             : std::exp(2 * log_of_factorial(1.5 * n) - 6 * log_of_factorial(n / 2) +
                                                        3 * log_of_factorial(n) - log_of_factorial(3 * n + 1));
    double const wave = r > 0 ? std::legendre(static_cast<unsigned>(shape.mode), x[0] / r) : 0;
    return shape.radius / std::cbrt(1 + 3 * a * a / (2 * n + 1) + a * a * a * cubes) * (1 + a * wave);
}

/// The radius [m] of a column at x [m] from its middle, R0 (1 + a cos(2 pi n x/length)), its volume that of the
/// cylinder of its radius, R0^2 (1 + a^2/2).
inline double column_radius(Shape const& shape, double x) {
    double const a = shape.amplitude;
    return shape.radius / std::sqrt(1 + a * a / 2) *
           (1 + a * std::cos(2 * std::numbers::pi * shape.mode * x / shape.length));
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
    } else if (shape.kind == "drop") {
        inside = std::sqrt(norm2(y)) <= drop_radius(shape, y) + slack;
    } else if (shape.kind == "column") {
        double across2 = 0;
        for (int k = 1; k < D; ++k) across2 += y[k] * y[k];
        inside =
            std::fabs(y[0]) <= shape.length / 2 + slack && std::sqrt(across2) <= column_radius(shape, y[0]) + slack;
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

/// How far the shape goes from its centre along each of its own axes [m].
template <int D>
Vector<double, D> half_extents(Shape const& shape) {
    Vector<double, D> half;
    for (int k = 0; k < D; ++k)
        half[k] = shape.kind == "box"       ? shape.size[k] / 2
                  : shape.kind == "ellipse" ? shape.semi_axes[k]
                  : shape.kind == "drop"    ? shape.radius * (1 + std::fabs(shape.amplitude))
                  : shape.kind != "column"  ? shape.radius
                  : k == 0                  ? shape.length / 2
                                            : shape.radius * (1 + std::fabs(shape.amplitude));
    return half;
}

/// How far the shape goes from its centre along a direction g, given in its own axes, times the length of g.
template <int D>
double extent(Shape const& shape, Vector<double, D> const& g) {
    auto const half = half_extents<D>(shape);
    double sum = 0, sum2 = 0;
    for (int k = 0; k < D; ++k) {
        sum += std::fabs(g[k]) * half[k];
        sum2 += g[k] * g[k] * half[k] * half[k];
    }
    return shape.kind == "box" || shape.kind == "column" ? sum : std::sqrt(sum2);
}

}  // namespace coronet
