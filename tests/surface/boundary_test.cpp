// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "coronet/surface/boundary_finder.hpp"

namespace coronet {

namespace {

using std::numbers::pi;
using Points = std::vector<Vector<double, 2>>;

constexpr double coverage = 1.2, support = 3.5;  // spacings, which are 1 here

struct Found {
    Particles<2> particles;
    Boundary<2> boundary;
};

Found boundary_of(Points const& points, double volume = 1) {
    Found found{Particles<2>(points.size()), {}};
    auto& particles = found.particles;
    particles.allocate(Fields<Position, Mass, Acceleration>{});
    for (std::size_t i = 0; i < points.size(); ++i) {
        particles.view().set<Position>(i, points[i]);
        particles.view().set<Mass>(i, 1.0 + 0.1 * static_cast<double>(i % 7));
    }
    Neighbours<2> neighbours(support, 0);
    neighbours.update(particles);
    found.boundary = find_boundary(particles, neighbours, coverage, 1.0, volume);
    return found;
}

/// Points of a lattice inside a circle, moved by up to `jitter` each way.
Points disc(double radius, double jitter, unsigned seed, Vector<double, 2> const& centre = {}) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-jitter, jitter);
    Points points;
    int const reach = static_cast<int>(radius) + 1;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            if (x * x + y * y <= radius * radius)
                points.push_back(centre + Vector<double, 2>{{x + uniform(engine), y + uniform(engine)}});
    return points;
}

/// Points on shells, a spacing apart along and across.
Points shells(double radius) {
    Points points;
    for (double r = radius - 0.5; r > 0.4; r -= 1) {
        int const count = static_cast<int>(std::lround(2 * pi * r));
        for (int k = 0; k < count; ++k)
            points.push_back({{r * std::cos(2 * pi * k / count), r * std::sin(2 * pi * k / count)}});
    }
    return points;
}

double cross(Vector<double, 2> const& a, Vector<double, 2> const& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

TEST(Boundary, OfAHexagonalLatticeHasTheVolumeOfItsParticles) {
    // A hexagon of rings 0 to 8: its sides are rows, whose particles have half of a row's distance outside of them.
    double const V = std::sqrt(3.0) / 2;
    Points points;
    for (int a = -8; a <= 8; ++a)
        for (int b = std::max(-8, -8 - a); b <= std::min(8, 8 - a); ++b) points.push_back({{a + 0.5 * b, V * b}});
    auto const content = boundary_of(points, V).boundary.content[0];
    EXPECT_NEAR(content / (V * static_cast<double>(points.size())), 1, 5e-3);  // corners are cut; with 1 for V, +1.5 %
}

TEST(Boundary, ForcesOfSizeAndContentHaveNoSumAndNoTorqueOnRandomClouds) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        auto const [particles, boundary] = boundary_of(disc(9, 0.6, seed, {{40, -30}}));
        for (auto const* gradient : {&boundary.of_size, &boundary.of_content}) {
            Vector<double, 2> force{};
            double torque = 0, forces = 0;
            for (std::size_t i = 0; i < particles.size(); ++i) {
                auto const& F = (*gradient)[i];
                force += F;
                torque += cross(particles.view().get<Position>(i) - Vector<double, 2>{{40, -30}}, F);
                forces += std::sqrt(norm2(F));
            }
            EXPECT_LT(std::sqrt(norm2(force)), 1e-14 * forces);
            EXPECT_LT(std::fabs(torque), 1e-14 * 9 * forces);
        }
    }
}

/// Along a random direction, beside central differences.
void expect_derivatives(Points const& points) {
    auto const found = boundary_of(points);
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Points direction(points.size());
    double of_size = 0, of_content = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        direction[i] = {{uniform(engine), uniform(engine)}};
        for (std::size_t k = 0; k < points.size(); ++k) {  // a listing has re-ordered them
            if (static_cast<std::size_t>(found.particles.id[k]) != i) continue;
            of_size += dot(found.boundary.of_size[k], direction[i]);
            of_content += dot(found.boundary.of_content[k], direction[i]);
        }
    }
    double const e = 1e-6;
    Points plus = points, minus = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        plus[i] += e * direction[i];
        minus[i] += -e * direction[i];
    }
    auto const after = boundary_of(plus).boundary, before = boundary_of(minus).boundary;
    EXPECT_NEAR((after.size[0] - before.size[0]) / (2 * e), of_size, 1e-7);
    EXPECT_NEAR((after.content[0] - before.content[0]) / (2 * e), of_content, 1e-7);
}

TEST(Boundary, GradientsAreTheDerivativesOfSizeAndContent) { expect_derivatives(disc(6, 0.2, 3)); }

TEST(Boundary, GradientsAreTheDerivativesWhereAThreadEnds) {
    // A thread of single particles that is bent, and whose last one nearly coincides with another.
    Points points = disc(5, 0.1, 5);
    for (int k = 0; k < 8; ++k) points.push_back({{6.0 + 0.8 * k, 0.1 * k * k}});
    points.push_back({{11.61, 4.94}});
    expect_derivatives(points);
    auto const [particles, boundary] = boundary_of(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LT(norm2(boundary.of_size[i]), 5 * 5);
        EXPECT_LT(norm2(boundary.of_content[i]), 5 * 5);
    }
}

/// Particles that move, and the boundary that is found each time.
struct Moving {
    Particles<2> particles;
    Neighbours<2> neighbours;
    SurfaceSettings settings{};
    BoundaryFinder<2> find;

    Moving(Points const& points, double skin) : particles(points.size()), neighbours(support, skin) {
        particles.allocate(Fields<Position, Surface>{});
        settings.spacing = settings.volume = 1;
        settings.coverage_radius = coverage;
    }

    void go(Points const& points) {
        for (std::size_t i = 0; i < points.size(); ++i)
            particles.view().set<Position>(i, points[static_cast<std::size_t>(particles.id[i])]);
        neighbours.update(particles);
    }
    Boundary<2> at(Points const& points) {
        go(points);
        return find(particles, neighbours, settings);
    }
};

TEST(BoundaryFinder, CountsByHowMuchTheSizeJumpsWhereAParticleJoins) {
    Points points = shells(8);
    Moving drop(points, 0);
    drop.at(points);
    for (auto& x : points) x = 1.001 * x;  // the same particles
    double const before = drop.at(points).total_size();
    EXPECT_EQ(drop.find.jumps(), 0);
    points.back() = {{8.9, 0.1}};  // from the middle to the outside
    double const after = drop.at(points).total_size();
    EXPECT_GT(std::fabs(after - before), 0.1);
    EXPECT_NEAR(drop.find.jumps(), std::fabs(after - before), 1e-12);
}

TEST(BoundaryFinder, SeesEveryParticleThatCanHaveComeToTheSurface) {
    // Loose clouds. Neighbours are listed; every particle goes one way along a line, almost half the skin, and the
    // boundary is found; then all go as far the other way. Two particles come apart by almost two skins.
    constexpr double skin = 0.25;
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> angle(0, pi);
    std::bernoulli_distribution forwards(0.5);
    std::size_t joined = 0;
    for (unsigned cloud = 0; cloud < 40; ++cloud) {
        Points const points = disc(9, 0.45, cloud);
        Moving moving(points, skin);
        moving.go(points);
        double const direction = angle(engine);
        Vector<double, 2> const way{{0.49 * skin * std::cos(direction), 0.49 * skin * std::sin(direction)}};
        Points there = points, back = points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            double const sign = forwards(engine) ? 1 : -1;
            there[i] += sign * way;
            back[i] += -sign * way;
        }
        double const* const surface = moving.particles.view().at<Surface>();
        moving.at(there);
        std::vector<double> const before(surface, surface + points.size());
        auto const found = moving.at(back);
        for (std::size_t i = 0; i < points.size(); ++i) joined += surface[i] > before[i];
        auto const fresh = find_boundary(moving.particles, moving.neighbours, coverage, 1, 1);
        EXPECT_EQ(found.size, fresh.size);
        EXPECT_EQ(found.content, fresh.content);
        EXPECT_EQ(moving.neighbours.listings(), 1u);
    }
    EXPECT_GT(joined, 100u);
}

TEST(Boundary, OfAHalfPlaneStandsHalfASpacingOutside) {
    // A wide box: its sides are edges of a lattice but near the corners.
    Points points;
    int const n = 40;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y) points.push_back({{1.0 * x, 1.0 * y}});
    auto const boundary = boundary_of(points).boundary;
    EXPECT_EQ(boundary.pieces, 1u);
    // The corners' points lie about a spacing and a half inside of those of the square of n x n: less than a hundredth.
    EXPECT_NEAR(boundary.content[0], n * n, 0.002 * n * n);
    EXPECT_NEAR(boundary.size[0], 4 * n, 0.02 * 4 * n);
}

TEST(Boundary, OfADropIsItsCircle) {
    for (double const radius : {10.0, 20.0}) {
        auto const boundary = boundary_of(shells(radius)).boundary;
        EXPECT_NEAR(boundary.size[0], 2 * pi * radius, 0.3 / radius * 2 * pi * radius);
        EXPECT_NEAR(boundary.content[0], pi * radius * radius, 0.5 / radius * pi * radius * radius);
    }
}

TEST(Boundary, MovesAsTheLiquidDoesInAFlowWithoutDivergence) {
    // Mode n of a drop: v = grad r^n cos(n theta). The content stays, and the boundary at radius R moves by R^(n-1).
    double const R = 20;
    auto const [particles, boundary] = boundary_of(shells(R));
    for (int const n : {2, 3, 4}) {
        double content = 0, moves = 0;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            auto const x = particles.view().get<Position>(i);
            double const r = std::sqrt(norm2(x)), theta = std::atan2(x[1], x[0]), speed = std::pow(r / R, n - 1);
            Vector<double, 2> const v{{speed * std::cos((n - 1) * theta), -speed * std::sin((n - 1) * theta)}};
            content += dot(boundary.of_content[i], v);
            moves += std::sqrt(norm2(boundary.of_content[i]) * norm2(v));
        }
        EXPECT_LT(std::fabs(content), 1e-3 * moves) << n;
    }
}

TEST(Boundary, TellsPiecesApartAndKnowsVoids) {
    Points points = disc(6, 0, 1), others = disc(4, 0, 2, {{20, 0}});
    points.insert(points.end(), others.begin(), others.end());
    auto const two = boundary_of(points);
    ASSERT_EQ(two.boundary.pieces, 2u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool const first = two.particles.view().get<Position>(i)[0] < 10;
        EXPECT_EQ(two.boundary.piece_of(i) == two.boundary.piece_of(0),
                  first == (two.particles.view().get<Position>(0)[0] < 10));
    }
    Points ring;
    for (auto const& x : disc(9, 0, 1))
        if (norm2(x) > 9.5) ring.push_back(x);
    auto const whole = boundary_of(disc(9, 0, 1)).boundary, open = boundary_of(ring).boundary;
    EXPECT_EQ(open.pieces, 1u);
    EXPECT_GT(open.size[0], whole.size[0] + 5);
    EXPECT_LT(open.content[0], whole.content[0] - 10);
}

TEST(BoundaryTension, DoesTheWorkThatTheSurfaceLoses) {
    auto [particles, boundary] = boundary_of(disc(8, 0.2, 4));
    add_tension(particles, boundary, 0.07);
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto const force = view.at<Mass>()[i] * view.get<Acceleration>(i);
        EXPECT_LT(norm2(force + 0.07 * boundary.of_size[i]), 1e-30);
    }
}

}  // namespace coronet
