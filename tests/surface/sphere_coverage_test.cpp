// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/sphere_coverage.hpp"

#include <gtest/gtest.h>

#include <random>

#include "coronet/surface/frame.hpp"

namespace {

using namespace coronet;

using Point = Vector<double, 3>;

struct Ball {
    Point x;
    double R;
};
using Balls = std::vector<Ball>;

bool same_as_ours(Ball const& ball) { return norm2(ball.x) < 1e-14 && std::fabs(ball.R - 1) < 1e-7; }

Point unit(Point const& p) { return 1 / std::sqrt(norm2(p)) * p; }

bool outside_all(Balls const& balls, Point const& u) {
    for (Ball const& ball : balls)
        if (!same_as_ours(ball) && std::sqrt(norm2(u - ball.x)) <= ball.R + 1e-9) return false;
    return true;
}

/// Looks for a point of the unit sphere outside all balls: on random points, just outside the circle of every ball, and
/// just outside both circles where two of them cross. What is open has such a corner, or a whole circle around.
bool open_somewhere(Balls const& balls, std::mt19937& engine) {
    std::normal_distribution<double> normal;
    for (int k = 0; k < 200; ++k)
        if (outside_all(balls, unit({{normal(engine), normal(engine), normal(engine)}}))) return true;
    constexpr double step = 1e-5;
    struct Circle {
        Point n;
        double c;
    };
    std::vector<Circle> circles;
    for (Ball const& ball : balls) {
        double const d = std::sqrt(norm2(ball.x)), c = (1 + d * d - ball.R * ball.R) / (2 * d);
        if (!same_as_ours(ball) && std::fabs(c) < 1) circles.push_back({1 / d * ball.x, c});
    }
    for (auto const& [n, c] : circles) {
        auto const [e1, e2] = tangents(n);
        for (int k = 0; k < 8; ++k) {
            double const out = c - step;
            if (std::fabs(out) < 1 &&
                outside_all(balls, out * n + std::sqrt(1 - out * out) * (std::cos(k) * e1 + std::sin(k) * e2)))
                return true;
        }
    }
    for (auto const& a : circles)
        for (auto const& b : circles) {
            // u = p a + q b +- r a x b with u . a and u . b a step below the planes.
            double const g = dot(a.n, b.n), det = 1 - g * g;
            if (!(det > 1e-10)) continue;
            double const ca = a.c - step, cb = b.c - step, p = (ca - g * cb) / det, q = (cb - g * ca) / det;
            double const r2 = (1 - p * p - q * q - 2 * p * q * g) / det;
            if (!(r2 > 0)) continue;
            Point const cross{{a.n[1] * b.n[2] - a.n[2] * b.n[1], a.n[2] * b.n[0] - a.n[0] * b.n[2],
                               a.n[0] * b.n[1] - a.n[1] * b.n[0]}};
            for (double const side : {-1, 1})
                if (outside_all(balls, p * a.n + q * b.n + side * std::sqrt(r2) * cross)) return true;
        }
    return false;
}

SphereCoverage coverage_by(Balls const& balls) {
    SphereCoverage coverage;
    for (Ball const& ball : balls) coverage.add({ball.x, 1, ball.R});
    return coverage;
}

/// Both ways of the routine say what points say. Returns whether the sphere is covered.
bool expect_right(Balls const& balls, std::mt19937& engine) {
    auto coverage = coverage_by(balls);
    bool const covered = coverage.covered(), open = open_somewhere(balls, engine);
    EXPECT_EQ(covered, !open);
    EXPECT_EQ(coverage.circles_are_covered(), !open);
    return covered;
}

TEST(SphereCoverage, AgreesWithPointsOnTheSphereForRandomClouds) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> place(-1.3, 1.3), radius(0.4, 1.4);
    int covered = 0;
    for (int cloud = 0; cloud < 3000; ++cloud) {
        Balls balls(static_cast<std::size_t>(cloud % 48));
        for (Ball& ball : balls)
            ball = {{{place(engine), place(engine), place(engine)}}, cloud % 3 == 0 ? radius(engine) : 1};
        covered += expect_right(balls, engine);
    }
    EXPECT_GT(covered, 700);
    EXPECT_LT(covered, 2300);
}

TEST(SphereCoverage, AgreesForCloudsOnALatticeWithTwins) {
    std::mt19937 engine(2);
    std::uniform_int_distribution<int> place(-2, 2), size(1, 3);
    int covered = 0;
    for (int cloud = 0; cloud < 3000; ++cloud) {
        Balls balls(static_cast<std::size_t>(cloud % 100));
        for (Ball& ball : balls)
            ball = {{{place(engine) * 0.75, place(engine) * 0.75, place(engine) * 0.75}},
                    cloud % 3 == 0 ? size(engine) * 0.5 : 1};
        covered += expect_right(balls, engine);
    }
    EXPECT_GT(covered, 700);
    EXPECT_LT(covered, 2300);
}

TEST(SphereCoverage, FindsAHoleHoweverSmall) {
    // Two rings of caps and one at the far side leave a hole at a pole that narrows as the first ring comes nearer.
    for (double const hole : {0.3, 0.1, 0.01, 1e-3, 1e-5, -1e-5, -1e-3, -0.1}) {
        SphereCoverage coverage;
        for (int k = 0; k < 5; ++k) {
            double const angle = 2 * std::numbers::pi * k / 5, polar = 0.9;
            Point const n{{std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)}};
            coverage.add(Cap<3>(n, std::cos(polar - hole)));
            coverage.add(Cap<3>({{n[0], n[1], -0.7 * n[2]}}, 0.4));
        }
        coverage.add(Cap<3>({{0, 0, -1}}, 0.4));
        EXPECT_EQ(coverage.covered(), hole < 0) << hole;
        EXPECT_EQ(coverage.circles_are_covered(), hole < 0) << hole;
    }
}

TEST(SphereCoverage, OfALatticeIsFullAndWhatTouchesCloses) {
    // Six neighbours cover from half a space diagonal on, twelve of the face-centred lattice from half an edge of the
    // cube on.
    struct Lattice {
        double step, closes;
        bool face_centred;
    };
    for (auto const& [step, closes, face_centred] : {Lattice{1, std::sqrt(0.75), false}, {1, 1, true}})
        for (double const larger : {1 - 1e-6, 1.0, 1.01, 1.2, 1.5}) {
            Balls balls;
            double const unit_length = 1 / (closes * larger);
            for (int x = -4; x <= 4; ++x)
                for (int y = -4; y <= 4; ++y)
                    for (int z = -4; z <= 4; ++z) {
                        if (face_centred && (x + y + z) % 2 != 0) continue;
                        Point const at = unit_length * step * Point{{x * 1.0, y * 1.0, z * 1.0}};
                        if ((x != 0 || y != 0 || z != 0) && norm2(at) <= 4) balls.push_back({at, 1});
                    }
            EXPECT_EQ(coverage_by(balls).covered(), larger >= 1) << closes << ' ' << larger;
            EXPECT_EQ(coverage_by(balls).circles_are_covered(), larger >= 1) << closes << ' ' << larger;
            std::erase_if(balls, [](Ball const& ball) { return ball.x[2] > 0; });
            EXPECT_FALSE(coverage_by(balls).covered());
        }
}

TEST(SphereCoverage, OfSpecialPairs) {
    EXPECT_FALSE(coverage_by({}).covered());
    EXPECT_TRUE(coverage_by({{{{0.25, 0, 0}}, 1.25}}).covered());               // touched from outside, contained
    EXPECT_TRUE(coverage_by({{{{0, 0, 0}}, 1.5}}).covered());                   // concentric and larger
    EXPECT_FALSE(coverage_by({{{{0, 0, 0}}, 0.5}}).covered());                  // concentric and smaller
    EXPECT_FALSE(coverage_by({{{{0, 0.5, 0}}, 0.5}}).covered());                // touched from inside
    EXPECT_FALSE(coverage_by({{{{0, 0, 0}}, 1}}).covered());                    // the same
    EXPECT_FALSE(coverage_by({{{{0, 1e-9, 0}}, 1}}).covered());                 // the same but for rounding
    EXPECT_FALSE(coverage_by({{{{0, 0, 2}}, 1}}).covered());                    // touched
    EXPECT_FALSE(coverage_by({{{{0, 0, 1}}, 1}, {{{0, 0, 1}}, 1}}).covered());  // twins have one circle
    // Two halves: closed caps of the same circle.
    EXPECT_TRUE(coverage_by({{{{0, 0, 1}}, std::sqrt(2)}, {{{0, 0, -1}}, std::sqrt(2)}}).covered());
    EXPECT_FALSE(coverage_by({{{{0, 0, 1}}, std::sqrt(2)}, {{{0, 0, -1}}, 1.4142}}).covered());
}

}  // namespace
