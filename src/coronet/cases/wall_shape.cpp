// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_shape.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/cases/closed_surface.hpp"
#include "coronet/cases/shapes.hpp"

namespace coronet {

namespace {

/// Of a body: the normal points out of it.
template <int D>
WallPoint<D> of_box(Vector<double, D> const& x, std::vector<double> const& size) {
    Vector<double, D> outside;
    int nearest = 0;
    for (int k = 0; k < D; ++k) {
        double const beyond = std::fabs(x[k]) - size[k] / 2;
        outside[k] = std::copysign(std::max(beyond, 0.0), x[k]);
        if (beyond > std::fabs(x[nearest]) - size[nearest] / 2) nearest = k;
    }
    double const distance = std::sqrt(norm2(outside));
    if (distance > 0) return {distance, (1 / distance) * outside};
    Vector<double, D> normal;
    normal[nearest] = std::copysign(1.0, x[nearest]);
    return {std::fabs(x[nearest]) - size[nearest] / 2, normal};
}

template <int D>
WallPoint<D> of_ball(Vector<double, D> const& x, double radius) {
    double const r = std::sqrt(norm2(x));
    Vector<double, D> normal;
    normal[0] = 1;
    if (r > 0) normal = (1 / r) * x;
    return {r - radius, normal};
}

/// The nearest point y of an ellipse (ellipsoid) of semi-axes a has x - y along the normal there, so that
/// y_k = a_k^2 x_k/(a_k^2 + t) with sum (y_k/a_k)^2 = 1: that sum falls with t > -least a^2, and the root is found by
/// bisection of t + least a^2, which may be tiny.
template <int D>
WallPoint<D> of_ellipse(Vector<double, D> x, std::vector<double> const& a) {
    double const least = *std::min_element(a.begin(), a.end());
    Vector<double, D> scaled;
    for (int k = 0; k < D; ++k) {  // off the axes, where two points may be as near
        x[k] = std::copysign(std::max(std::fabs(x[k]), 1e-12 * a[k]), x[k]);
        scaled[k] = a[k] * x[k];
    }
    double low = 0, high = std::sqrt(norm2(scaled));
    auto const nearest = [&](double t) {
        Vector<double, D> y;
        for (int k = 0; k < D; ++k) y[k] = a[k] * scaled[k] / ((a[k] - least) * (a[k] + least) + t);
        return y;
    };
    auto const over = [&](Vector<double, D> const& y) {
        double sum = 0;
        for (int k = 0; k < D; ++k) sum += y[k] * y[k] / (a[k] * a[k]);
        return sum;
    };
    for (int n = 0; n < 300; ++n) {
        double const middle = (low + high) / 2;
        if (middle <= low || middle >= high) break;
        (over(nearest(middle)) > 1 ? low : high) = middle;
    }
    auto const y = nearest(high);
    Vector<double, D> normal;
    for (int k = 0; k < D; ++k) normal[k] = y[k] / (a[k] * a[k]);
    normal = (1 / std::sqrt(norm2(normal))) * normal;
    return {dot(x - y, normal), normal};
}

/// A polygon's corners are the items of its list two by two.
WallPoint<2> of_polygon(Vector<double, 2> const& x, std::vector<double> const& corners) {
    std::size_t const count = corners.size() / 2;
    bool inside = false;
    double least2 = INFINITY;
    Vector<double, 2> away, across;
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t const next = (k + 1) % count;
        Vector<double, 2> const a{{corners[2 * k], corners[2 * k + 1]}}, b{{corners[2 * next], corners[2 * next + 1]}};
        auto const edge = b - a;
        double const along = std::clamp(dot(x - a, edge) / norm2(edge), 0.0, 1.0);
        auto const from = x - (a + along * edge);
        if (norm2(from) < least2) {
            least2 = norm2(from);
            away = from;
            across = {{edge[1], -edge[0]}};
        }
        bool const crosses = (a[1] > x[1]) != (b[1] > x[1]);
        if (crosses && x[0] < a[0] + (x[1] - a[1]) / edge[1] * edge[0]) inside = !inside;
    }
    double const distance = std::sqrt(least2), sign = inside ? -1 : 1;
    if (distance == 0) return {0, (1 / std::sqrt(norm2(across))) * across};
    return {sign * distance, (sign / distance) * away};
}

}  // namespace

template <int D>
WallPoint<D> nearest_wall_point(Wall const& wall, Vector<double, D> const& x) {
    Vector<double, D> from_centre;
    for (int k = 0; k < D; ++k) from_centre[k] = x[k] - wall.centre[k];
    auto const y = turned(from_centre, -wall.rotation);
    WallPoint<D> point = wall.kind == "box"       ? of_box(y, wall.size)
                         : wall.kind == "ellipse" ? of_ellipse(y, wall.semi_axes)
                                                  : of_ball(y, wall.radius);
    if constexpr (D == 2)
        if (wall.kind == "polygon") point = of_polygon(y, wall.corners);
    if constexpr (D == 3)
        if (wall.kind == "mesh") {
            auto const nearest = wall.surface->nearest(y);
            point = {nearest.distance, nearest.normal};
        }
    point.normal = turned(point.normal, wall.rotation);
    return wall.solid == "inside" ? point : WallPoint<D>{-point.distance, -point.normal};
}

template <int D>
Vector<double, D> half_extents(Wall const& wall) {
    Vector<double, D> half;
    for (int k = 0; k < D; ++k)
        half[k] = wall.kind == "box"       ? wall.size[k] / 2
                  : wall.kind == "ellipse" ? wall.semi_axes[k]
                  : wall.kind == "mesh"
                      ? std::max(std::fabs(wall.surface->low()[k]), std::fabs(wall.surface->high()[k]))
                      : wall.radius;
    if (wall.kind == "polygon")
        for (int k = 0; k < D; ++k) {
            half[k] = 0;
            for (std::size_t at = static_cast<std::size_t>(k); at < wall.corners.size(); at += 2)
                half[k] = std::max(half[k], std::fabs(wall.corners[at]));
        }
    if (wall.rotation == 0) return half;
    double const across = std::hypot(half[0], half[1]);
    half[0] = half[1] = across;
    return half;
}

template WallPoint<2> nearest_wall_point(Wall const&, Vector<double, 2> const&);
template WallPoint<3> nearest_wall_point(Wall const&, Vector<double, 3> const&);
template Vector<double, 2> half_extents(Wall const&);
template Vector<double, 3> half_extents(Wall const&);

}  // namespace coronet
