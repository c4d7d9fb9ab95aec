// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/reconstruct.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "coronet/core/error.hpp"
#include "coronet/surface/detect.hpp"
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

}  // namespace
