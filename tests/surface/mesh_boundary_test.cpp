// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/mesh_boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "coronet/core/error.hpp"
#include "tests/surface/closed_mesh.hpp"

namespace coronet {

namespace {

using std::numbers::pi;
using Vector3 = Vector<double, 3>;
using Points = std::vector<Vector3>;

constexpr double coverage = 1.4, support = 3;  // spacings, which are 1 here

struct Found {
    Particles<3> particles;
    SurfaceMesh mesh;
    Boundary<3> boundary;

    explicit Found(Points const& points, double radius = coverage) : particles(points.size()) {
        particles.allocate(Fields<Position>{});
        for (std::size_t i = 0; i < points.size(); ++i) particles.view().set<Position>(i, points[i]);
        Neighbours<3> neighbours(support, 0);
        neighbours.update(particles);
        mesh = find_mesh(particles, neighbours, radius);
        boundary = boundary_of(mesh, particles, neighbours, radius, 1, 1);
    }

    /// The boundary with the same triangles after particles have moved, each by `by` of where it stands in the list.
    Boundary<3> after(double step, Points const& direction) {
        for (std::size_t i = 0; i < particles.size(); ++i)
            particles.view().set<Position>(i, particles.view().get<Position>(i) + step * direction[i]);
        Neighbours<3> const unused(support, 0);
        return boundary_of(mesh, particles, unused, coverage, 1, 1);
    }
};

/// Points of a lattice inside a ball, moved by up to `jitter` each way.
Points ball(double radius, double jitter, unsigned seed, Vector3 const& centre = {}) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-jitter, jitter);
    Points points;
    int const reach = static_cast<int>(radius) + 1;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = -reach; z <= reach; ++z)
                if (x * x + y * y + z * z <= radius * radius)
                    points.push_back(centre + Vector3{{x + uniform(engine), y + uniform(engine), z + uniform(engine)}});
    return points;
}

/// Points on shells, a spacing apart along and across, as many as there is volume.
Points shells(double radius) {
    Points points;
    for (double r = radius - 0.5; r > 0; r -= 1) {
        int const count = static_cast<int>(std::lround(4 * pi / 3 * (std::pow(r + 0.5, 3) - std::pow(r - 0.5, 3))));
        for (int k = 0; k < count; ++k) {
            double const z = 1 - (2 * k + 1.0) / count, s = std::sqrt(1 - z * z), angle = (3 - std::sqrt(5)) * pi * k;
            points.push_back({{r * s * std::cos(angle), r * s * std::sin(angle), r * z}});
        }
    }
    return points;
}

Vector3 cross(Vector3 const& a, Vector3 const& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// V - E + F.
long euler(SurfaceMesh const& mesh) {
    auto const triangles = static_cast<long>(mesh.triangles.size());
    return static_cast<long>(mesh.vertices()) - triangles / 2;
}

}  // namespace

TEST(SurfaceMesh, IsClosedWithEachTriangleTurnedOutwards) {
    for (auto const& points : {ball(6, 0, 1), ball(6, 0.3, 2), shells(8)}) {
        Found const found(points);
        auto const& mesh = found.mesh;
        EXPECT_EQ(euler(mesh), 2);  // of a sphere
        expect_closed(mesh);
        EXPECT_GT(found.boundary.content[0], 0);
    }
}

TEST(SurfaceMesh, IsThatOfADelaunayTriangulationOnACube) {
    Points points;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            for (int z = 0; z < 4; ++z) points.push_back({{1.0 * x, 1.0 * y, 1.0 * z}});
    Found const found(points);
    EXPECT_EQ(found.mesh.vertices(), 56u);               // all but the 2 x 2 x 2 inside
    EXPECT_EQ(found.mesh.triangles.size(), 6u * 9 * 2);  // two for each square, however the draw falls
}

TEST(SurfaceMesh, GoesTwiceAroundASheetAndLeavesRowsAlone) {
    Points sheet, row;
    int const n = 20;
    for (int x = 0; x < n; ++x) {
        row.push_back({{1.0 * x, 0, 0}});
        for (int y = 0; y < n; ++y) sheet.push_back({{1.0 * x, 1.0 * y, 0}});
    }
    Found const found(sheet);
    EXPECT_EQ(found.mesh.triangles.size(), 2u * 2 * (n - 1) * (n - 1));
    EXPECT_EQ(found.mesh.vertices(), static_cast<std::size_t>(n * n + (n - 2) * (n - 2)));  // its inside twice
    EXPECT_EQ(euler(found.mesh), 2);
    EXPECT_GT(found.boundary.content[0], (n - 3) * (n - 3));  // a spacing thick, but falling to nothing at the rim
    EXPECT_LT(found.boundary.content[0], (n - 1) * (n - 1));
    EXPECT_TRUE(Found(row).mesh.triangles.empty());
    EXPECT_TRUE(Found(Points(1)).mesh.triangles.empty());
}

TEST(MeshBoundary, ForcesOfSizeAndContentHaveNoSumAndNoTorqueOnRandomClouds) {
    Vector3 const centre{{40, -30, 20}};
    for (unsigned seed = 0; seed < 10; ++seed) {
        Found const found(ball(6, 0.6, seed, centre));
        for (auto const* gradient : {&found.boundary.of_size, &found.boundary.of_content}) {
            Vector3 force{}, torque{};
            double forces = 0;
            for (std::size_t i = 0; i < found.particles.size(); ++i) {
                auto const& F = (*gradient)[i];
                force += F;
                torque += cross(found.particles.view().get<Position>(i) - centre, F);
                forces += std::sqrt(norm2(F));
            }
            EXPECT_GT(forces, 1);
            EXPECT_LT(std::sqrt(norm2(force)), 1e-13 * forces);
            EXPECT_LT(std::sqrt(norm2(torque)), 1e-13 * 6 * forces);
        }
    }
}

TEST(MeshBoundary, GradientsAreTheDerivativesOfSizeAndContent) {
    for (double const jitter : {0.2, 0.6}) {  // the latter has folds and crowds
        Found found(ball(5, jitter, 3));
        std::mt19937_64 engine(7);
        std::uniform_real_distribution<double> uniform(-1, 1);
        Points direction(found.particles.size());
        double of_size = 0, of_content = 0;
        for (std::size_t i = 0; i < direction.size(); ++i) {
            direction[i] = {{uniform(engine), uniform(engine), uniform(engine)}};
            of_size += dot(found.boundary.of_size[i], direction[i]);
            of_content += dot(found.boundary.of_content[i], direction[i]);
        }
        double const e = 1e-6;
        auto const plus = found.after(e, direction), minus = found.after(-2 * e, direction);
        double const scale = std::fabs(of_size) + std::fabs(of_content) + 1;
        EXPECT_NEAR((plus.total_size() - minus.total_size()) / (2 * e), of_size, 1e-7 * scale);
        EXPECT_NEAR((plus.total_content() - minus.total_content()) / (2 * e), of_content, 1e-7 * scale);
    }
}

TEST(MeshBoundary, OfADropIsItsSphere) {
    for (double const radius : {8.0, 16.0}) {  // triangles are chords: of second order
        auto const boundary = Found(shells(radius)).boundary;
        EXPECT_EQ(boundary.pieces, 1u);
        double const error = 0.5 / (radius * radius);
        EXPECT_NEAR(boundary.size[0] / (4 * pi * radius * radius), 1, error);
        EXPECT_NEAR(boundary.content[0] / (4 * pi / 3 * std::pow(radius, 3)), 1, 2 * error);
    }
}

TEST(MeshBoundary, OfACubeIsItsCells) {
    Points points;
    int const n = 10;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z) points.push_back({{1.0 * x, 1.0 * y, 1.0 * z}});
    auto const boundary = Found(points).boundary;
    EXPECT_NEAR(boundary.content[0], n * n * n, 0.01 * n * n * n);
    EXPECT_NEAR(boundary.size[0], 6 * n * n, 0.01 * 6 * n * n);
}

TEST(MeshBoundary, MovesAsTheLiquidDoesInAFlowWithoutDivergence) {
    // A drop drawn to a spheroid of twice the length: where it is, the layer outside of the outermost particles is
    // thinner at the sides and thicker at the ends, so that no content is lost, and the area is that of the spheroid.
    double const R = 12, stretch = std::cbrt(4.0), a = R * stretch, b = R / std::sqrt(stretch);
    auto points = shells(R);
    auto const round = Found(points).boundary;
    for (auto& x : points) x = {{x[0] / std::sqrt(stretch), x[1] / std::sqrt(stretch), x[2] * stretch}};
    auto const stretched = Found(points).boundary;
    double const e = std::sqrt(1 - b * b / (a * a)), area = 2 * pi * b * b * (1 + a / (b * e) * std::asin(e));
    EXPECT_NEAR(stretched.content[0] / round.content[0], 1, 1e-3);
    EXPECT_NEAR(stretched.size[0] / round.size[0], area / (4 * pi * R * R), 1e-3);
}

TEST(MeshBoundary, TellsPiecesApart) {
    Points points = ball(4, 0, 1), others = ball(3, 0, 2, {{20, 0, 0}});
    points.insert(points.end(), others.begin(), others.end());
    Found const two(points);
    ASSERT_EQ(two.boundary.pieces, 2u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool const first = two.particles.view().get<Position>(i)[0] < 10;
        EXPECT_EQ(two.boundary.piece_of(i) == two.boundary.piece_of(0),
                  first == (two.particles.view().get<Position>(0)[0] < 10));
    }
    // What has no triangles is a piece, too: one particle, and a row of three.
    auto sprayed = ball(4, 0, 1);
    sprayed.insert(sprayed.end(), {{{9, 0, 0}}, {{0, 9, 0}}, {{0, 10, 0}}, {{0, 11, 0}}});
    EXPECT_EQ(Found(sprayed).boundary.pieces, 3u);
    auto near = ball(5, 0, 1);  // within the kernel's radius, not within twice the coverage radius
    near.push_back({{0, 0, 5 + 2.6}});
    EXPECT_EQ(Found(near, 1.2).boundary.pieces, 2u);
    Points hollow;
    for (auto const& x : ball(6, 0, 1))
        if (norm2(x) > 6.5) hollow.push_back(x);
    auto const whole = Found(ball(6, 0, 1)).boundary, open = Found(hollow).boundary;
    EXPECT_EQ(open.pieces, 1u);
    EXPECT_GT(open.size[0], whole.size[0] + 5);
    EXPECT_LT(open.content[0], whole.content[0] - 5);
}

TEST(SurfaceMesh, SaysWhenNeighboursAreNotKnownFarEnough) { EXPECT_THROW(Found(ball(3, 0, 1), 1.6), CaseError); }

}  // namespace coronet
