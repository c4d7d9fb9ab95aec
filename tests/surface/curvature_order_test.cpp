// SPDX-License-Identifier: BSD-3-Clause

// With what power of the spacing normals and curvatures converge, printed and asserted, on ellipsoids of known
// curvature.
//
// A fitted quadratic misses the cubic term of the surface. It spoils the curvature in first order of the spacing if
// points lie unevenly, and not at all if they lie symmetrically: then the next term leaves second order. A circle and a
// sphere have no cubic term over their tangent, so there uneven points keep second order too. The slope misses the
// cubic term in second order in any case. Points that are off the surface by e add about e/spacing^2 to the curvature.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "coronet/surface/detect.hpp"
#include "coronet/surface/frame.hpp"
#include "coronet/surface/reconstruct.hpp"
#include "tests/neighbours/points.hpp"

namespace {

using namespace coronet;
using namespace coronet::test;

constexpr double pi = std::numbers::pi;

/// x A x = 1, A = diag(1/axes^2). Its outward normal is A x/|A x|, whose divergence is the sum of the curvatures.
template <int D>
struct Ellipsoid {
    Vector<double, D> axes;

    Vector<double, D> Ax(Vector<double, D> x) const {
        for (int k = 0; k < D; ++k) x[k] /= axes[k] * axes[k];
        return x;
    }
    Vector<double, D> normal(Vector<double, D> const& x) const { return 1 / std::sqrt(norm2(Ax(x))) * Ax(x); }
    double curvature(Vector<double, D> const& x) const {
        double trace = 0;
        for (double const axis : axes.c) trace += 1 / (axis * axis);
        auto const g = Ax(x);
        return (trace - dot(g, Ax(g)) / norm2(g)) / std::sqrt(norm2(g));
    }
    Vector<double, D> pulled_onto(Vector<double, D> const& x) const { return 1 / std::sqrt(dot(x, Ax(x))) * x; }
};

/// Evenly along the arc.
Points<2> points_on(Ellipsoid<2> const& ellipse, std::size_t count) {
    auto const at = [&](double t) {
        return Vector<double, 2>{{ellipse.axes[0] * std::cos(t), ellipse.axes[1] * std::sin(t)}};
    };
    std::size_t const fine = 64 * count;
    std::vector<double> length{0};
    for (std::size_t k = 0; k < fine; ++k) {
        double const t = 2 * pi * (static_cast<double>(k) + 0.5) / static_cast<double>(fine);
        length.push_back(length.back() + std::hypot(ellipse.axes[0] * std::sin(t), ellipse.axes[1] * std::cos(t)));
    }
    Points<2> points;
    for (std::size_t i = 0, k = 0; i < count; ++i) {
        double const wanted = length.back() * static_cast<double>(i) / static_cast<double>(count);
        while (length[k + 1] <= wanted) ++k;
        double const part = (wanted - length[k]) / (length[k + 1] - length[k]);
        points.push_back(at(2 * pi * (static_cast<double>(k) + part) / static_cast<double>(fine)));
    }
    return points;
}

/// Along a Fibonacci spiral, which is a lattice locally.
Points<3> points_on(Ellipsoid<3> const& ellipsoid, std::size_t count) {
    Points<3> points;
    for (std::size_t i = 0; i < count; ++i) {
        double const z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count), r = std::sqrt(1 - z * z);
        double const angle = static_cast<double>(i) * pi * (3 - std::sqrt(5));
        points.push_back({{ellipsoid.axes[0] * r * std::cos(angle), ellipsoid.axes[1] * r * std::sin(angle),
                           ellipsoid.axes[2] * z}});
    }
    return points;
}

/// Shifts every point along the surface, by up to `share` of the spacing along each tangent.
template <int D>
void jitter(Ellipsoid<D> const& shape, Points<D>& points, double spacing, double share) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (auto& x : points) {
        for (auto const& t : tangents(shape.normal(x))) x += share * spacing * uniform(engine) * t;
        x = shape.pulled_onto(x);
    }
}

struct Errors {
    double spacing, curvature, normal;  ///< root mean squares; the curvature's in units of its mean
};

/// Fits at some 500 of the points, in frames that are 20 degrees off.
template <int D>
Errors errors_of_fits(Ellipsoid<D> const& shape, std::size_t count, double share) {
    auto points = points_on(shape, count);
    double spacing = 2 * pi * std::hypot(shape.axes[0], shape.axes[1]) / std::sqrt(2) / static_cast<double>(count);
    if (D == 3)
        spacing = std::sqrt(4 * pi / static_cast<double>(count)) *
                  std::cbrt(shape.axes[0] * shape.axes[1] * shape.axes[D - 1]);
    jitter(shape, points, spacing, share);
    SurfaceFit const fit{2.5 * spacing};
    double curvature = 0, normal = 0, mean = 0, fits = 0;
    for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, count / 500)) {
        Points<D> around;
        for (std::size_t j = 0; j < count; ++j)
            if (j != i && norm2(points[j] - points[i]) < fit.width * fit.width) around.push_back(points[j] - points[i]);
        auto const n = shape.normal(points[i]);
        auto tilted = n + 0.36 * tangents(n)[0];
        auto const local = fit_surface<D>(around, 1 / std::sqrt(norm2(tilted)) * tilted, fit);
        EXPECT_TRUE(local.fitted);
        double const exact = shape.curvature(points[i]);
        curvature += (local.curvature - exact) * (local.curvature - exact);
        mean += exact;
        normal += norm2(local.normal - n);
        ++fits;
    }
    return {spacing, std::sqrt(curvature / fits) / (mean / fits), std::sqrt(normal / fits)};
}

struct Orders {
    double curvature, normal;  ///< between the finest two
};

Orders report(std::string const& what, std::vector<Errors> const& series) {
    Errors const &a = series[series.size() - 2], &b = series.back();
    double const finer = std::log(a.spacing / b.spacing);
    Orders const orders{std::log(a.curvature / b.curvature) / finer, std::log(a.normal / b.normal) / finer};
    fmt::print("{:<38} spacing {:.4f}: curvature {:.2e}, order {:5.2f}; normal {:.2e}, order {:5.2f}\n", what,
               b.spacing, b.curvature, orders.curvature, b.normal, orders.normal);
    testing::Test::RecordProperty("order_of_curvature", fmt::format("{:.3f}", orders.curvature));
    testing::Test::RecordProperty("order_of_normal", fmt::format("{:.3f}", orders.normal));
    return orders;
}

template <int D>
Orders orders_on(std::string const& what, Ellipsoid<D> const& shape, double share) {
    std::vector<Errors> series;
    std::size_t const counts[] = {D == 2 ? 400u : 16000u, D == 2 ? 800u : 64000u};
    for (std::size_t const count : counts) series.push_back(errors_of_fits(shape, count, share));
    return report(what, series);
}

Ellipsoid<2> const circle{{{1, 1}}}, ellipse{{{1.3, 0.8}}};
Ellipsoid<3> const sphere{{{1, 1, 1}}}, spheroid{{{1.3, 1.3, 0.7}}};

TEST(CurvatureOrder, OnEvenPoints) {
    EXPECT_NEAR(orders_on("circle, even", circle, 0).curvature, 2, 0.1);
    auto const ellipse_orders = orders_on("ellipse, even", ellipse, 0);
    EXPECT_NEAR(ellipse_orders.curvature, 2, 0.1);
    EXPECT_NEAR(ellipse_orders.normal, 2, 0.1);
    auto const sphere_orders = orders_on("sphere, even", sphere, 0);
    EXPECT_NEAR(sphere_orders.curvature, 2, 0.3);
    auto const spheroid_orders = orders_on("spheroid, even", spheroid, 0);
    EXPECT_NEAR(spheroid_orders.curvature, 2, 0.3);
    EXPECT_NEAR(spheroid_orders.normal, 2, 0.3);
}

TEST(CurvatureOrder, OnPointsJitteredAlongTheSurface) {
    EXPECT_NEAR(orders_on("circle, jittered", circle, 0.3).curvature, 2, 0.3);
    auto const ellipse_orders = orders_on("ellipse, jittered", ellipse, 0.3);
    EXPECT_NEAR(ellipse_orders.curvature, 1, 0.3);
    EXPECT_NEAR(ellipse_orders.normal, 2, 0.3);
    EXPECT_NEAR(orders_on("sphere, jittered", sphere, 0.3).curvature, 2, 0.3);
    auto const spheroid_orders = orders_on("spheroid, jittered", spheroid, 0.3);
    EXPECT_NEAR(spheroid_orders.curvature, 1, 0.3);
    EXPECT_NEAR(spheroid_orders.normal, 2, 0.3);
}

/// A body filled with a lattice, its own surface covered with points or not.
template <int D>
Errors errors_of_body(Ellipsoid<D> const& shape, double spacing, bool covered_with_points) {
    Points<D> points;
    std::size_t on_surface = 0;
    double inner = 1;
    if (covered_with_points) {
        double const size = D == 2 ? 2 * pi * std::hypot(shape.axes[0], shape.axes[1]) / std::sqrt(2) / spacing
                                   : 4 * pi / (spacing * spacing);
        points = points_on(shape, static_cast<std::size_t>(size));
        jitter(shape, points, spacing, 0.3);
        on_surface = points.size();
        inner = 1 - 0.7 * spacing;
    }
    int const side = static_cast<int>(2 * 1.5 / spacing);
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(-0.1 * spacing, 0.1 * spacing);
    for (auto x : lattice<D>(side, spacing)) {
        for (double& c : x.c) c += covered_with_points ? uniform(engine) - 1.5 : -1.5;
        if (dot(x, shape.Ax(x)) < inner * inner) points.push_back(x);
    }
    auto particles = particles_at<D>(points);
    Neighbours<D> neighbours(3 * spacing, 0.1 * spacing);
    neighbours.update(particles);
    mark_surface(particles, neighbours, spacing);
    if (covered_with_points)
        for (std::size_t i = 0; i < points.size(); ++i)
            particles.template get<Surface>()[i] = particles.id[i] < static_cast<std::int64_t>(on_surface);
    reconstruct_surface(particles, neighbours, {2.5 * spacing});
    auto const view = particles.view();
    double curvature = 0, normal = 0, mean = 0, fits = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (view.template at<Surface>()[i] == 0) {
            EXPECT_EQ(norm2(view.template get<SurfaceNormal>(i)), 0);
            continue;
        }
        EXPECT_NEAR(norm2(view.template get<SurfaceNormal>(i)), 1, 1e-14);
        EXPECT_EQ(view.template at<SurfaceFitted>()[i], 1);
        auto const x = shape.pulled_onto(view.template get<Position>(i));
        double const error = view.template at<Curvature>()[i] - shape.curvature(x);
        curvature += error * error;
        mean += shape.curvature(x);
        normal += norm2(view.template get<SurfaceNormal>(i) - shape.normal(x));
        ++fits;
    }
    return {spacing, std::sqrt(curvature / fits) / (mean / fits), std::sqrt(normal / fits)};
}

TEST(CurvatureOrder, OfABodyWhoseSurfaceIsCoveredWithPoints) {
    auto const in_2d = report("ellipse, body covered with points",
                              {errors_of_body(ellipse, 0.04, true), errors_of_body(ellipse, 0.02, true)});
    EXPECT_NEAR(in_2d.curvature, 1, 0.3);
    EXPECT_NEAR(in_2d.normal, 2, 0.3);
    auto const in_3d = report("sphere, body covered with points",
                              {errors_of_body(sphere, 0.12, true), errors_of_body(sphere, 0.06, true)});
    EXPECT_NEAR(in_3d.curvature, 2, 0.4);
}

TEST(CurvatureOrder, OfABodyCutOutOfALattice) {
    // The particles lie off the surface by a share of the spacing, whatever that is: normals are off by some angle, and
    // curvatures by some share of 1/spacing. Only a surface that has become smooth by moving has a curvature.
    for (auto const& orders : {report("disc cut out of a lattice",
                                      {errors_of_body(circle, 0.04, false), errors_of_body(circle, 0.02, false)}),
                               report("ball cut out of a lattice",
                                      {errors_of_body(sphere, 0.12, false), errors_of_body(sphere, 0.06, false)})}) {
        EXPECT_NEAR(orders.curvature, -1, 0.3);
        EXPECT_NEAR(orders.normal, 0, 0.3);
    }
}

}  // namespace
