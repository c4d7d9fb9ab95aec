// SPDX-License-Identifier: BSD-3-Clause

// The boundary of a liquid that is periodic along an axis, the mesh going on across the period.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "coronet/surface/mesh_boundary.hpp"
#include "tests/surface/closed_mesh.hpp"

namespace coronet {

namespace {

using std::numbers::pi;
using Vector3 = Vector<double, 3>;
using Points = std::vector<Vector3>;

constexpr double coverage = 1.4, support = 3, L = 14;  // spacings, which are 1 here

struct Found {
    Particles<3> particles;
    Neighbours<3> neighbours;
    SurfaceMesh mesh;
    Boundary<3> boundary;

    explicit Found(Points const& points, bool periodic = true)
        : particles(points.size()), neighbours(support, 0, 0, {{{0, 0, 0}}, {{L, 1, 1}}, {periodic, false, false}}) {
        particles.allocate(Fields<Position>{});
        for (std::size_t i = 0; i < points.size(); ++i) particles.view().set<Position>(i, points[i]);
        neighbours.update(particles);
        mesh = find_mesh(particles, neighbours, coverage);
        boundary = now();
    }
    Boundary<3> now() { return boundary_of(mesh, particles, neighbours, coverage, 1, 1); }
    Vector3 at(std::size_t i) const { return particles.view().get<Position>(i); }
};

/// A jittered lattice in a column along x of a radius, over one period from `begin` on.
Points column(double radius, double jitter, double begin = 0) {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> uniform(-jitter, jitter);
    Points points;
    int const reach = static_cast<int>(radius) + 1;
    for (int x = 0; x < L; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = -reach; z <= reach; ++z)
                if (y * y + z * z <= radius * radius)
                    points.push_back({{begin + x + uniform(engine), y + uniform(engine), z + uniform(engine)}});
    return points;
}

Vector3 cross(Vector3 const& a, Vector3 const& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

}  // namespace

TEST(PeriodicMesh, OfAColumnIsATorus) {
    for (double const jitter : {0.0, 0.3}) {
        auto const mesh = Found(column(4, jitter)).mesh;
        EXPECT_EQ(mesh.vertices(), mesh.triangles.size() / 2);  // V - E + F = 0
        expect_closed(mesh);
        EXPECT_TRUE(std::ranges::all_of(mesh.parts(), [](Index part) { return part == 0; }));
    }
}

TEST(PeriodicMesh, IsThatOfTheMiddleOfThreePeriods) {
    auto const points = column(4, 0.3);
    Points three;
    for (double const shift : {-L, 0.0, L})
        for (auto const& x : points) three.push_back(x + Vector3{{shift, 0, 0}});
    Found const one(points), middle(three, false);
    double size = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto const id = static_cast<std::size_t>(one.particles.id[i]);
        std::size_t j = 0;
        while (static_cast<std::size_t>(middle.particles.id[j]) != points.size() + id) ++j;
        EXPECT_LT(std::sqrt(norm2(one.boundary.of_size[i] - middle.boundary.of_size[j])), 1e-13);
        EXPECT_LT(std::sqrt(norm2(one.boundary.of_content[i] - middle.boundary.of_content[j])), 1e-13);
        size += std::sqrt(norm2(one.boundary.of_size[i]));
    }
    EXPECT_GT(size, 10);
}

TEST(PeriodicMesh, HasTheAreaAndTheVolumeOfOnePeriodWhereverItBegins) {
    // Concentric rings, staggered, as many as there is volume.
    double const R = 6;
    Points points;
    for (double r = R - 0.5; r > 0; r -= 1) {
        int const around = static_cast<int>(std::lround(2 * pi * r));
        for (int x = 0; x < L; ++x)
            for (int k = 0; k < around; ++k) {
                double const angle = 2 * pi * (k + 0.5 * (x % 2)) / around;
                points.push_back({{x + 0.3, r * std::cos(angle), r * std::sin(angle)}});
            }
    }
    Found const one(points);
    EXPECT_NEAR(one.boundary.size[0], 2 * pi * R * L, 0.01 * 2 * pi * R * L);
    EXPECT_NEAR(one.boundary.content[0], pi * R * R * L, 0.01 * pi * R * R * L);
    for (auto& x : points) x += Vector3{{5.7, 100, -30}};
    Found const elsewhere(points);
    EXPECT_NEAR(elsewhere.boundary.size[0], one.boundary.size[0], 1e-9 * one.boundary.size[0]);
    EXPECT_NEAR(elsewhere.boundary.content[0], one.boundary.content[0], 1e-9 * one.boundary.content[0]);
}

TEST(PeriodicMesh, ForcesHaveNoSumAndNoTorqueAboutTheAxis) {
    for (double const jitter : {0.2, 0.6}) {
        Found const found(column(4, jitter));
        for (auto const* gradient : {&found.boundary.of_size, &found.boundary.of_content}) {
            Vector3 force{};
            double torque = 0, forces = 0;
            for (std::size_t i = 0; i < found.particles.owned(); ++i) {
                auto const& F = (*gradient)[i];
                force += F;
                torque += cross(found.at(i), F)[0];
                forces += std::sqrt(norm2(F));
            }
            EXPECT_GT(forces, 1);
            EXPECT_LT(std::sqrt(norm2(force)), 1e-13 * forces);
            EXPECT_LT(std::fabs(torque), 1e-13 * 4 * forces);
        }
    }
}

TEST(PeriodicMesh, GradientsAreTheDerivativesOfSizeAndContentAcrossThePeriod) {
    Found found(column(4, 0.4));
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Points direction(found.particles.owned());
    double of_size = 0, of_content = 0;
    for (std::size_t i = 0; i < direction.size(); ++i) {
        direction[i] = {{uniform(engine) + 1, uniform(engine), uniform(engine)}};
        of_size += dot(found.boundary.of_size[i], direction[i]);
        of_content += dot(found.boundary.of_content[i], direction[i]);
    }
    double const e = 1e-6;
    auto const moved = [&](double step) {
        for (std::size_t i = 0; i < direction.size(); ++i)
            found.particles.view().set<Position>(i, found.at(i) + step * direction[i]);
        return found.now();
    };
    auto const plus = moved(e), minus = moved(-2 * e);
    EXPECT_NEAR((plus.total_size() - minus.total_size()) / (2 * e), of_size, 1e-7 * (1 + std::fabs(of_size)));
    EXPECT_NEAR((plus.total_content() - minus.total_content()) / (2 * e), of_content,
                1e-7 * (1 + std::fabs(of_content)));
}

TEST(PeriodicMesh, OfADropAcrossThePeriodIsThatOfTheDrop) {
    Points ball;
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> uniform(-0.2, 0.2);
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            for (int z = -4; z <= 4; ++z)
                if (x * x + y * y + z * z <= 16)
                    ball.push_back({{x + uniform(engine), y + uniform(engine), z + uniform(engine)}});
    auto const across = Found(ball).boundary, alone = Found(ball, false).boundary;
    EXPECT_EQ(across.pieces, 1u);
    EXPECT_NEAR(across.size[0], alone.size[0], 1e-12 * alone.size[0]);
    EXPECT_NEAR(across.content[0], alone.content[0], 1e-12 * alone.content[0]);
    // With another one beside it there are two pieces, as without a period.
    std::size_t const one = ball.size();
    for (std::size_t i = 0; i < one; ++i) ball.push_back(ball[i] + Vector3{{0, 20, 0}});
    EXPECT_EQ(Found(ball).boundary.pieces, 2u);
}

}  // namespace coronet
