// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/closed_surface.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "coronet/core/error.hpp"
#include "tests/io/mesh_files.hpp"

namespace coronet {

namespace {

Triangles triangles(Mesh const& mesh) {
    Triangles all;
    all.corners = mesh;
    for (std::size_t k = 0; k < mesh.size(); ++k) all.place.push_back(k + 1);
    return all;
}

ClosedSurface surface(Mesh const& mesh, double unit = 1) { return ClosedSurface(triangles(mesh), unit, "mesh.stl"); }

std::string complaint(Mesh const& mesh) {
    try {
        surface(mesh);
    } catch (CaseError const& error) {
        return error.what();
    }
    return "nothing";
}

void expect_in(std::string const& part, std::string const& said) {
    EXPECT_NE(said.find(part), std::string::npos) << "'" << part << "' is not in: " << said;
}

/// An axis-aligned block, its faces cut into triangles.
Mesh block(Vector<double, 3> const& low, Vector<double, 3> const& size) {
    Mesh mesh = cube();
    for (auto& triangle : mesh)
        for (auto& p : triangle)
            for (int k = 0; k < 3; ++k) p[k] = low[k] + size[k] * p[k];
    return mesh;
}

double distance_to_unit_cube(Vector<double, 3> const& x) {
    double beyond2 = 0, inside = -1e300;
    for (int k = 0; k < 3; ++k) {
        double const b = std::fabs(x[k] - 0.5) - 0.5;
        beyond2 += b > 0 ? b * b : 0;
        inside = std::max(inside, b);
    }
    return beyond2 > 0 ? std::sqrt(beyond2) : inside;
}

}  // namespace

TEST(ClosedSurface, OfACubeIsWhereTheCubeIs) {
    auto const found = surface(cube());
    EXPECT_NEAR(found.volume(), 1, 1e-15);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> along(-0.7, 1.7);
    for (int n = 0; n < 20000; ++n) {
        Vector<double, 3> x{{along(random), along(random), along(random)}};
        if (n % 3 == 0) x[n % 2] = 0.25 * std::round(4 * x[n % 2]);  // on planes, edges and diagonals of the faces
        if (n % 5 == 0) x[2] = x[0];
        auto const [distance, normal] = found.nearest(x);
        EXPECT_NEAR(distance, distance_to_unit_cube(x), 1e-14);
        EXPECT_NEAR(norm2(normal), 1, 1e-12);
        // Along the normal lies the surface.
        if (distance != 0) {
            EXPECT_NEAR(distance_to_unit_cube(x - distance * normal), 0, 1e-14);
        }
    }
}

TEST(ClosedSurface, KnowsInsideFromOutsideInNotchesAndAtSharpEdges) {
    // Two blocks that are one body in an L, without the faces between them: as a fan of its two ends.
    Mesh mesh;
    std::vector<Vector<double, 2>> const outline{{{0, 0}}, {{2, 0}}, {{2, 0.3}}, {{0.3, 0.3}}, {{0.3, 2}}, {{0, 2}}};
    auto const at = [&](std::size_t k, double z) {
        return Vector<double, 3>{{outline[k % 6][0], outline[k % 6][1], z}};
    };
    for (std::size_t k = 0; k < 6; ++k) {
        mesh.push_back({at(k, 0), at(k + 1, 0), at(k + 1, 1)});
        mesh.push_back({at(k, 0), at(k + 1, 1), at(k, 1)});
    }
    std::size_t const ends[][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    for (auto const& [a, b, c] : ends) {
        mesh.push_back({at(a, 1), at(b, 1), at(c, 1)});
        mesh.push_back({at(a, 0), at(c, 0), at(b, 0)});
    }
    auto const found = surface(mesh);
    EXPECT_NEAR(found.volume(), 2 * 0.3 + 1.7 * 0.3, 1e-14);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> along(-0.5, 2.5);
    for (int n = 0; n < 20000; ++n) {
        Vector<double, 3> const x{{along(random), along(random), along(random)}};
        bool const in_plan = x[0] > 0 && x[1] > 0 && ((x[0] < 2 && x[1] < 0.3) || (x[0] < 0.3 && x[1] < 2));
        EXPECT_EQ(found.nearest(x).distance < 0, in_plan && x[2] > 0 && x[2] < 1);
    }
    // A needle: all that is in front of its tip is outside.
    double const w = 0.01;
    Vector<double, 3> const tip{{1, 0, 0}}, p{{0, w, 0}}, q{{0, -w, w}}, r{{0, -w, -w}};
    auto const needle = surface({{tip, p, q}, {tip, q, r}, {tip, r, p}, {p, r, q}});
    for (int n = 0; n < 2000; ++n) {
        double const angle = 2 * std::numbers::pi * n / 2000;
        EXPECT_GT(needle.nearest(tip + 0.1 * Vector<double, 3>{{0.2, std::cos(angle), std::sin(angle)}}).distance, 0);
    }
    EXPECT_LT(needle.nearest({{0.5, 0, 0}}).distance, 0);
}

TEST(ClosedSurface, OfASphereIsWithinItsSagitta) {
    double const radius = 0.4;
    auto const found = surface(sphere(radius, 5), 1);
    std::mt19937 random(3);
    std::normal_distribution<double> along(0, 0.4);
    for (int n = 0; n < 5000; ++n) {
        Vector<double, 3> const x{{along(random), along(random), along(random)}};
        double const r = std::sqrt(norm2(x));
        auto const [distance, normal] = found.nearest(x);
        EXPECT_NEAR(distance, r - radius, 1.5e-3 * radius);
        if (r > 0.2 * radius && std::fabs(r - radius) > 0.05 * radius) {
            EXPECT_GT(dot(normal, x), 0.98 * r);
        }
    }
    EXPECT_NEAR(found.volume(), 4 * std::numbers::pi / 3 * std::pow(radius, 3), 3e-3 * found.volume());
    EXPECT_NEAR(surface(sphere(400, 3), 1e-3).volume(), surface(sphere(0.4, 3)).volume(), 1e-12);
}

TEST(ClosedSurface, SeenFromInsideIsTheSame) {
    Mesh turned = cube();
    for (auto& triangle : turned) std::swap(triangle[1], triangle[2]);
    EXPECT_NEAR(surface(turned).nearest({{0.5, 0.5, 0.9}}).distance, -0.1, 1e-15);
    EXPECT_NEAR(surface(turned).nearest({{0.5, 0.5, 1.2}}).normal[2], 1, 1e-15);
    EXPECT_NEAR(surface(turned).volume(), 1, 1e-15);
}

TEST(ClosedSurface, MayBeOfSeveralPieces) {
    Mesh two = cube();
    for (auto const& triangle : block({{2, 0, 0}}, {{1, 1, 1}})) two.push_back(triangle);
    auto const found = surface(two);
    EXPECT_NEAR(found.nearest({{1.4, 0.5, 0.5}}).distance, 0.4, 1e-15);
    EXPECT_NEAR(found.nearest({{2.1, 0.5, 0.5}}).distance, -0.1, 1e-15);
}

TEST(ClosedSurface, SaysWhatIsNotClosed) {
    Mesh open = cube();
    open.pop_back();
    expect_in("has a triangle on one side only", complaint(open));
    Mesh seam = cube();
    seam[3][0] = seam[3][0] + Vector<double, 3>{{1e-7, 0, 0}};
    expect_in("must be closed", complaint(seam));
    Mesh flipped = cube();
    std::swap(flipped[5][0], flipped[5][1]);
    expect_in("in the same sense by 2 triangles", complaint(flipped));
    Mesh flat = cube();
    flat.push_back({cube()[0][0], cube()[0][1], cube()[0][1]});
    expect_in("mesh.stl:13: a triangle has no area", complaint(flat));
    Mesh doubled = cube();
    doubled.push_back(doubled[0]);
    expect_in("in the same sense by 2 triangles, here and at mesh.stl:13", complaint(doubled));
}

}  // namespace coronet
