// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/reconstruct.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "coronet/core/error.hpp"
#include "coronet/surface/frame.hpp"
#include "tests/neighbours/points.hpp"

namespace {

using namespace coronet;
using namespace coronet::test;

constexpr double pi = std::numbers::pi;

template <int D>
LocalSurface<D> fit_to(Points<D> const& points, Vector<double, D> const& outward, SurfaceFit const& fit) {
    return fit_surface<D>(points, 1 / std::sqrt(norm2(outward)) * outward, fit);
}

/// Curvature times dx^2/amplitude of a straight row of spacing dx = 1 that is displaced by a small cos(q s), at a
/// crest.
double response(double q, SurfaceFit const& fit) {
    double const amplitude = 1e-6;
    Points<2> row;
    for (int k = -4; k <= 4; ++k)
        if (k != 0) row.push_back({{1.0 * k, amplitude * (std::cos(q * k) - 1)}});
    return fit_to<2>(row, {{0, 1}}, fit).curvature / amplitude;
}

TEST(Reconstruction, RestoresWavesOfEveryLengthIfItsWeightsAreCompact) {
    for (double q = 0; q <= pi; q += pi / 50) {
        double const compact = response(q, {2.5}), none = response(q, {3.5, FitWeights::none});
        // -f'' by least squares over the row, from the moments of the weights; rounding and the square of the slope.
        double s0 = 1, s2 = 0, s4 = 0, f0 = 1, f2 = 0;
        for (int k = 1; k <= 2; ++k) {
            double const weight = 2 * std::pow(1 - k * k / 6.25, 3);
            s0 += weight, s2 += weight * k * k, s4 += weight * k * k * k * k;
            f0 += weight * std::cos(q * k), f2 += weight * k * k * std::cos(q * k);
        }
        EXPECT_NEAR(compact, -2 * (s0 * f2 - s2 * f0) / (s0 * s4 - s2 * s2), 1e-8);
        EXPECT_NEAR(compact, 0.849 - 0.465 * std::cos(q) - 0.384 * std::cos(2 * q), 2e-3);
        EXPECT_NEAR(none, -(-4 - 6 * std::cos(q) + 10 * std::cos(3 * q)) / 42, 1e-8);
        EXPECT_GE(compact, 0.25 * std::min(q * q, 1.0) - 1e-8) << "q = " << q;
    }
    EXPECT_NEAR(response(2 * pi / 3, {3.5, FitWeights::none}), -9.0 / 42, 1e-8) << "as printed, it feeds this wave";
    EXPECT_LT(response(pi, {3.5}), 0) << "and so do compact weights that are too wide, the zigzag";
}

TEST(Reconstruction, IsExactAtTheVertexOfAQuadricWhicheverWayItIsTurned) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int trial = 0; trial < 100; ++trial) {
        Vector<double, 3> n{{uniform(engine), uniform(engine), uniform(engine)}};
        n = 1 / std::sqrt(norm2(n)) * n;
        auto const [e1, e2] = tangents(n);
        EXPECT_NEAR(norm2(e1), 1, 1e-15 * 8);
        EXPECT_NEAR(dot(e1, e2), 0, 1e-15);
        EXPECT_NEAR(determinant(Matrix<double, 3>{{e1[0], e1[1], e1[2], e2[0], e2[1], e2[2], n[0], n[1], n[2]}}), 1,
                    1e-14);
        double const a = uniform(engine), b = uniform(engine), c = uniform(engine);
        Points<3> points;
        for (int k = 0; k < 12; ++k) {
            double const x = 0.5 * uniform(engine), y = 0.5 * uniform(engine);
            points.push_back(x * e1 + y * e2 + (a * x * x + b * x * y + c * y * y) * n);
        }
        // The frame that is given is off by up to 20 degrees; the second one by what the first fit then misses.
        auto const exact = fit_to<3>(points, n, {2});
        ASSERT_TRUE(exact.fitted);
        EXPECT_NEAR(exact.curvature, -2 * (a + c), 1e-10);
        EXPECT_NEAR(dot(exact.normal, n), 1, 1e-10);
    }
    for (double const a : {-0.7, 0.0, 0.4}) {
        Points<2> points;
        for (double const x : {-0.5, -0.3, 0.1, 0.6}) points.push_back({{a * x * x, -x}});
        auto const exact = fit_to<2>(points, {{1, 0}}, {2, FitWeights::none});
        EXPECT_NEAR(exact.curvature, -2 * a, 1e-12);
        EXPECT_NEAR(exact.normal[0], 1, 1e-12);
    }
}

TEST(Reconstruction, KnowsTheCurvatureOfAGraphWhereverItSlopes) {
    for (double const x : {-0.8, 0.0, 0.3, 0.6}) {
        double const y = std::sqrt(1 - x * x);  // a circle's upper half: y' = -x/y, y'' = -1/y^3
        EXPECT_NEAR(curvature_of_graph(-x / y, -1 / (y * y * y)), 1, 1e-14);
        double const Y = 0.5, z = std::sqrt(1 - x * x / 1.5 - Y * Y / 1.5), z3 = z * z * z * 2.25;
        // x^2/1.5 + y^2/1.5 + z^2 = 1; the sum of its curvatures is the divergence of (x/1.5, y/1.5, z) over its
        // length.
        double const zx = -x / (1.5 * z), zy = -Y / (1.5 * z);
        double const zxx = -(z * z * 1.5 + x * x) / z3, zyy = -(z * z * 1.5 + Y * Y) / z3, zxy = -x * Y / z3;
        double const g2 = (x * x + Y * Y) / 2.25 + z * z;
        double const exact = (2 / 1.5 + 1 - ((x * x + Y * Y) / std::pow(1.5, 3) + z * z) / g2) / std::sqrt(g2);
        EXPECT_NEAR(curvature_of_graph(zx, zy, zxx, zxy, zyy), exact, 1e-13);
    }
}

TEST(Reconstruction, SaysWhereItCannotFit) {
    Vector<double, 2> const up{{0, 1}};
    auto const expect_none = [&](Points<2> const& points) {
        auto const none = fit_to<2>(points, up, {1});
        EXPECT_FALSE(none.fitted);
        EXPECT_EQ(none.curvature, 0);
        EXPECT_EQ(none.normal[1], 1);
    };
    expect_none({});
    expect_none({{{0.5, 0}}});
    expect_none({{{0.5, 0}}, {{1, 0}}});                   // one at the edge of the width counts no more
    expect_none({{{0.5, 0}}, {{0.5, 0}}, {{0, 0}}});       // all at two places
    expect_none({{{0.01, 0}}, {{0.02, 0}}, {{0.03, 0}}});  // too near together
    EXPECT_TRUE(fit_to<2>({{{0.5, 0}}, {{-0.5, 0}}}, up, {1}).fitted);
    Points<3> cross{{{0.3, 0, 0}}, {{0.6, 0, 0}}, {{-0.3, 0, 0}}, {{0, 0.3, 0}}, {{0, -0.3, 0}}, {{0, 0.6, 0}}};
    EXPECT_FALSE(fit_to<3>(cross, {{0, 0, 1}}, {1}).fitted) << "of two lines xy cannot be known";
    cross.push_back({{0.3, 0.3, 0}});
    EXPECT_TRUE(fit_to<3>(cross, {{0, 0, 1}}, {1}).fitted);
}

/// Particles on concentric circles around each centre, a spacing apart; the outermost circles are the surface.
Particles<2> discs(Points<2> const& centres, double radius, double spacing) {
    Points<2> points;
    std::vector<bool> outermost;
    for (auto const& centre : centres)
        for (double r = radius; r > 0.5 * spacing; r -= spacing) {
            double const count = std::round(2 * pi * r / spacing);
            for (double k = 0; k < count; ++k) {
                double const angle = 2 * pi * k / count;
                points.push_back(centre + r * Vector<double, 2>{{std::cos(angle), std::sin(angle)}});
                outermost.push_back(r == radius);
            }
        }
    auto particles = particles_at<2>(points);
    particles.allocate(Fields<Surface>{});
    for (std::size_t i = 0; i < points.size(); ++i) particles.get<Surface>()[i] = outermost[i];
    return particles;
}

TEST(Reconstruction, OfADropIsNotSpoiltByAnotherNearby) {
    double const spacing = 0.05;
    // Nearer than that, say one spacing apart, they are one liquid.
    for (double const gap : {10.0, 2.0, 1.5}) {
        auto particles = discs({{{-1 - gap * spacing / 2, 0}}, {{1 + gap * spacing / 2, 0}}}, 1, spacing);
        Neighbours<2> neighbours(3 * spacing, 0.1 * spacing);
        neighbours.update(particles);
        reconstruct_surface(particles, neighbours, {2.5 * spacing});
        for (std::size_t i = 0; i < particles.size(); ++i) {
            if (particles.get<Surface>()[i] == 0) continue;
            // On even points the quartic term of a circle, x^4/8, adds 2/8 (sum a_k k^4) dx^2 = 0.826 dx^2, with
            // a_k = 0.1162, 0.0960 what the fit weighs the first and second neighbour on each side with.
            EXPECT_NEAR(particles.get<Curvature>()[i], 1, 0.84 * spacing * spacing)
                << "x = " << particles.get<Position>(0)[i] << ", gap of " << gap << " spacings";
        }
    }
}

TEST(Reconstruction, OfALoneParticleHasNoNormal) {
    auto particles = particles_at<3>({{{1, 2, 3}}});
    particles.allocate(Fields<Surface>{});
    particles.get<Surface>()[0] = 1;
    Neighbours<3> neighbours(3, 0.1);
    neighbours.update(particles);
    reconstruct_surface(particles, neighbours, {2.5});
    EXPECT_EQ(particles.get<SurfaceFitted>()[0], 0);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(particles.get<SurfaceNormal>(k)[0], 0);
    EXPECT_THROW(reconstruct_surface(particles, neighbours, {3.01}), CaseError);
}

}  // namespace
