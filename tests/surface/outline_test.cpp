// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

using std::numbers::pi;
using Points = std::vector<Vector<double, 2>>;

constexpr double coverage = 1.2;  // spacings, which are 1 here

/// The outline with the points it runs through, which a listing re-orders.
struct Found {
    Outline outline;
    Polygon largest() const { return of(outline.largest()); }
    Polygon of(int loop) const {
        Polygon line;
        for (Index const i : outline.loops[static_cast<std::size_t>(loop)].particles)
            line.push_back(particles.view().get<Position>(static_cast<std::size_t>(i)));
        return line;
    }
    Particles<2> particles;
};

Found outline_of(Points const& points) {
    Found found{{}, Particles<2>(points.size())};
    found.particles.allocate(Fields<Position>{});
    for (std::size_t i = 0; i < points.size(); ++i) found.particles.view().set<Position>(i, points[i]);
    Neighbours<2> neighbours(2 * coverage, 0);
    neighbours.update(found.particles);
    found.outline = find_outline(found.particles, neighbours, coverage);
    return found;
}

Points lattice(int half, std::function<bool(double, double)> const& inside) {
    Points points;
    for (int x = -half; x <= half; ++x)
        for (int y = -half; y <= half; ++y)
            if (inside(x, y)) points.push_back({{static_cast<double>(x), static_cast<double>(y)}});
    return points;
}

PolygonMeasures liquid(Points const& points) { return measure(moved_out(outline_of(points).largest(), 0.5)); }

/// Points on shells, as particles lie where tension has drawn them round: a spacing apart along and across.
Points shells(double radius, double phase = 0) {
    Points points;
    for (double r = radius - 0.5; r > 0.4; r -= 1) {
        int const count = static_cast<int>(std::lround(2 * pi * r));
        for (int k = 0; k < count; ++k)
            points.push_back(
                {{r * std::cos(2 * pi * k / count + phase * r), r * std::sin(2 * pi * k / count + phase * r)}});
    }
    return points;
}

TEST(Outline, OfALatticeIsTheEdgeOfItsCells) {
    for (int const n : {2, 3, 10, 51}) {
        auto const square = lattice(60, [&](double x, double y) { return 0 <= x && x < n && 0 <= y && y < n; });
        auto const found = outline_of(square);
        ASSERT_EQ(found.outline.loops.size(), 1u);
        EXPECT_EQ(found.outline.particles, static_cast<std::size_t>(4 * n - 4));
        EXPECT_EQ(found.largest().size(), found.outline.particles);
        auto const cells = liquid(square);
        EXPECT_NEAR(cells.area, n * n, 1e-12 * n * n);
        EXPECT_NEAR(cells.perimeter, 4 * n, 1e-12 * n);
        EXPECT_NEAR(cells.centroid[0], (n - 1) / 2.0, 1e-12 * n);
    }
    EXPECT_NEAR(liquid(lattice(9, [](double, double y) { return y == 0; })).area, 19, 1e-12);  // a row
    EXPECT_EQ(liquid({{{3, 4}}}).area, 1);
    EXPECT_NEAR(liquid({{{3, 4}}, {{3.6, 4.8}}}).area, 2, 1e-12);
}

TEST(Outline, TurnsInwardsToo) {
    // The corner of an L is not of the surface: its neighbours cover it, and the outline passes it by on the outside.
    auto const l = lattice(20, [](double x, double y) { return !(x > 0 && y > 0); });
    EXPECT_NEAR(
        liquid(l).area,
        static_cast<double>(l.size()) + 0.5 + 0.25 * (2 * std::tan(-pi / 8) + 1) + 0.5 * (std::numbers::sqrt2 - 2),
        1e-9);
}

TEST(Outline, MovedOutIsThatOfParallelSides) {
    // A star with corners of both signs: A + d sum s + d^2 sum tan(a/2), while no corner is sharper than a right angle.
    for (double const depth : {0.05, 0.15}) {
        Polygon star;
        for (int k = 0; k < 12; ++k) {
            double const r = 10 * (1 + (k % 2 ? depth : -depth)), angle = 2 * pi * k / 12;
            star.push_back({{5 + r * std::cos(angle), r * std::sin(angle)}});
        }
        double corners = 0;
        for (std::size_t k = 0; k < 12; ++k) {
            auto const a = star[(k + 1) % 12] - star[k], b = star[(k + 2) % 12] - star[(k + 1) % 12];
            corners += std::tan(std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b)) / 2);
        }
        auto const before = measure(star);
        auto const after = measure(moved_out(star, 0.5));
        EXPECT_NEAR(after.area, before.area + 0.5 * before.perimeter + 0.25 * corners, 1e-12 * after.area);
        EXPECT_NEAR(after.centroid[0], 5, 1e-13 * 5);
        EXPECT_NEAR(after.centroid[1], 0, 1e-13 * 5);
    }
}

TEST(Outline, OfShellsIsTheDiscTheyFillToSecondOrder) {
    // Chords leave out s^2/6 of the area over the square of the radius; a corner moved out is (s/r)^2/8 d too far out.
    for (double const radius : {7.5, 14.5, 29.0, 58.0}) {
        double const error = liquid(shells(radius)).area / (pi * radius * radius) - 1;
        EXPECT_NEAR(error * radius * radius, -1 / 6.0, 0.2 / 6 + 1 / radius) << radius;
    }
}

TEST(Outline, OfAnEllipseHasItsAreaPerimeterAndCentre) {
    for (int const size : {20, 40}) {  // an image of shells: the spacing differs, and so does half of it, by 5 %
        Points points = shells(size);
        for (auto& x : points) x = {{100 + 1.05 * x[0], x[1] / 1.05 - 30}};
        auto const found = liquid(points);
        EXPECT_NEAR(found.area / (pi * size * size), 1, 3e-3) << size;
        EXPECT_NEAR(found.perimeter / (2 * pi * size), 1, 3e-3) << size;
        EXPECT_NEAR(found.centroid[0], 100, 1e-3);
        EXPECT_NEAR(found.centroid[1], -30, 1e-3);
    }
}

TEST(Outline, OfADiscCutFromALatticeIsWithinTheStepsOfItsEdge) {
    for (double const radius : {10.3, 20.3, 40.3}) {
        auto const points = lattice(60, [&](double x, double y) { return x * x + y * y <= radius * radius; });
        double const error = liquid(points).area - static_cast<double>(points.size());
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 0.1 * 2 * pi * radius) << radius;
    }
}

TEST(Outline, FindsVoidsAndPieces) {
    auto const holes = lattice(20, [](double x, double y) {
        return (x - 8) * (x - 8) + y * y > 9 && (x + 8) * (x + 8) + y * y > 4 && !(x == 0 && y == 17);
    });  // two holes; a single particle that is missing is none
    auto const found = outline_of(holes);
    EXPECT_EQ(found.outline.loops.size(), 3u);
    EXPECT_EQ(found.outline.voids(), 2);
    EXPECT_NEAR(liquid(holes).area, 41 * 41, 1e-9);
    for (int loop = 0; loop < 3; ++loop)
        EXPECT_EQ(loop == found.outline.largest(), measure(moved_out(found.of(loop), 0.5)).area > 0);

    auto pieces = lattice(3, [](double, double) { return true; });
    pieces.push_back({{9, 0}});
    pieces.push_back({{9, 9}});
    pieces.push_back({{9, 10}});
    auto const drops = outline_of(pieces);
    EXPECT_EQ(drops.outline.loops.size(), 3u);
    EXPECT_EQ(drops.outline.voids(), 0);
    EXPECT_EQ(drops.outline.particles, 24u + 3u);
    EXPECT_EQ(drops.largest().size(), 24u);
}

TEST(Outline, IsClosedForAnyCloud) {
    // Every arc of the boundary is in one loop, and the loops' areas add up to that of the union of the discs, here
    // counted on points.
    std::mt19937 engine(3);
    for (int cloud = 0; cloud < 40; ++cloud) {
        bool const on_lattice = cloud % 2;  // circles through one point, and twins
        std::uniform_real_distribution<double> place(-4, 4);
        Points points(static_cast<std::size_t>(5 + 2 * cloud));
        for (auto& x : points) {
            x = {{place(engine), place(engine)}};
            if (on_lattice) x = {{coverage * std::round(x[0]), coverage * std::round(x[1])}};
        }
        auto const found = outline_of(points);
        double area = 0;
        for (Loop const& loop : found.outline.loops) area += loop.area;
        int inside = 0, count = 400;
        double const reach = 7;
        for (int a = 0; a < count; ++a)
            for (int b = 0; b < count; ++b) {
                Vector<double, 2> const p{{reach * ((2 * a + 1.0) / count - 1), reach * ((2 * b + 1.0) / count - 1)}};
                inside += std::any_of(points.begin(), points.end(),
                                      [&](auto const& x) { return norm2(x - p) < coverage * coverage; });
            }
        double const cell = 4 * reach * reach / (count * count);
        if (on_lattice) EXPECT_GE(area, inside * cell - 1) << cloud;  // twins count their boundary twice
        else EXPECT_NEAR(area, inside * cell, 0.25) << cloud;
        for (Loop const& loop : found.outline.loops) EXPECT_FALSE(loop.particles.empty());
    }
}

TEST(Outline, RefusesNeighboursKnownTooNear) {
    Particles<2> particles(1);
    particles.allocate(Fields<Position>{});
    Neighbours<2> neighbours(2, 0);
    neighbours.update(particles);
    EXPECT_THROW(find_outline(particles, neighbours, 1.2), CaseError);
}

}  // namespace

}  // namespace coronet
