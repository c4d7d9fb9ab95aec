// SPDX-License-Identifier: BSD-3-Clause

// Where walls are, and which particles fill them.

#include "coronet/cases/wall_fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/read.hpp"

namespace coronet {

namespace {

Wall solid(std::string const& kind, std::vector<double> const& centre) {
    Wall wall;
    wall.kind = kind;
    wall.solid = "inside";
    wall.centre = centre;
    return wall;
}

Wall box() {
    Wall wall = solid("box", {1, 2});
    wall.size = {4, 2};
    return wall;
}

void expect_point(Wall const& wall, Vector<double, 2> const& x, double distance, Vector<double, 2> const& normal) {
    auto const point = nearest_wall_point(wall, x);
    EXPECT_NEAR(point.distance, distance, 1e-14);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(point.normal[k], normal[k], 1e-14);
}

/// A tank of 1 m x 1 m, its wall a box, 0.1 m between particles, a kernel of 0.27 m.
Case tank(std::string const& walls, std::string const& more = "") {
    return read_case(
        "name = 'tank'\ndimension = 2\n[particles]\nspacing = 0.1\norigin = 'cell'\n"
        "[fluid]\ndensity = 1\nsound_speed = 10\n[method]\nsupport = 2.7\n[time]\nend = 1\n"
        "[[shapes]]\nkind = 'box'\ncentre = [0.5, 0.5]\nsize = [3, 3]\n" +
            walls + more,
        "tank");
}
std::string const open_box = "[[walls]]\nkind = 'box'\ncentre = [0.5, 0.5]\nsize = [1, 1]\n";

}  // namespace

TEST(WallShapes, KnowHowFarTheyAreAndWhere) {
    double const root = std::sqrt(0.5);
    expect_point(box(), {{1, 3.5}}, 0.5, {{0, 1}});
    expect_point(box(), {{1.5, 2.9}}, -0.1, {{0, 1}});
    expect_point(box(), {{4, 4}}, std::sqrt(2), {{root, root}});
    Wall turned = box();
    turned.rotation = 90;
    expect_point(turned, {{1, 4.5}}, 0.5, {{0, 1}});
    Wall around = box();
    around.solid = "outside";
    expect_point(around, {{1, 3.5}}, -0.5, {{0, -1}});
    Wall disc = solid("disc", {0, 1});
    disc.radius = 2;
    expect_point(disc, {{0, 1.5}}, -1.5, {{0, 1}});
    expect_point(disc, {{3, 5}}, 3, {{0.6, 0.8}});
    // A triangle, whichever way round.
    Wall triangle = solid("polygon", {1, 0}), back = triangle;
    triangle.corners = {0, 0, 2, 0, 0, 2};
    back.corners = {0, 2, 2, 0, 0, 0};
    for (Wall const& wall : {triangle, back}) {
        expect_point(wall, {{2, -0.5}}, 0.5, {{0, -1}});
        expect_point(wall, {{1.25, 0.5}}, -0.25, {{-1, 0}});
        expect_point(wall, {{3, 2}}, std::sqrt(2), {{root, root}});
    }
}

TEST(WallShapes, EllipsesAreAsFarAsTheirNearestPoint) {
    Wall ellipse = solid("ellipse", {0, 0});
    ellipse.semi_axes = {2, 0.5};
    auto const by_search = [&](Vector<double, 2> const& x) {
        double least = 1e300;
        for (int n = 0; n < 40000; ++n) {
            double const angle = 2 * 3.14159265358979323846 * n / 40000;
            least = std::min(least, std::hypot(x[0] - 2 * std::cos(angle), x[1] - 0.5 * std::sin(angle)));
        }
        return x[0] * x[0] / 4 + x[1] * x[1] / 0.25 < 1 ? -least : least;
    };
    for (Vector<double, 2> const& x : {Vector<double, 2>{{0, 0}},
                                       {{1.9, 0}},
                                       {{0.3, 0}},
                                       {{0, 0.2}},
                                       {{3, 1}},
                                       {{-1, -0.3}},
                                       {{-0.1, 4}},
                                       {{2, 0.5}}}) {
        auto const point = nearest_wall_point(ellipse, x);
        EXPECT_NEAR(point.distance, by_search(x), 1e-7);
        auto const on = x - point.distance * point.normal;
        EXPECT_NEAR(on[0] * on[0] / 4 + on[1] * on[1] / 0.25, 1, 1e-9);
    }
    Wall ball = solid("ellipse", {0, 0, 0});
    ball.semi_axes = {0.5, 0.5, 0.5};
    EXPECT_NEAR(nearest_wall_point(ball, Vector<double, 3>{{0, 0.3, 0.4}}).distance, 0, 1e-12);
    EXPECT_NEAR(nearest_wall_point(ball, Vector<double, 3>{{0.1, 0, 0}}).distance, -0.4, 1e-9);
}

TEST(WallFill, KeepsApartWhatMovesApart) {
    // A plate on the floor that is lifted: the floor below it must be there, and look up.
    std::string const plate = "[[walls]]\nkind = 'box'\nsolid = 'inside'\ncentre = [0.5, 0.2]\nsize = [0.4, 0.4]\n";
    auto const still = fill_walls<2>(tank(open_box + plate));
    auto const lifted = fill_walls<2>(tank(open_box + plate + "displacement = [0, '0.1*t']\n"));
    auto const alone = fill_walls<2>(tank(open_box));
    std::size_t floor = 0;
    for (std::size_t k = 0; k < lifted.size(); ++k) floor += lifted.wall[k] == 0;
    EXPECT_EQ(floor, alone.size());
    EXPECT_EQ(lifted.size() - floor, 16u);
    auto const looks_up = [&](WallSeeds<2> const& walls) {  // as if there were no plate
        bool same = true;
        for (std::size_t k = 0; k < alone.size(); ++k)
            same = same && norm2(walls.to_mirror[k] - alone.to_mirror[k]) == 0;
        return same;
    };
    EXPECT_TRUE(looks_up(lifted));
    EXPECT_FALSE(looks_up(still));
}

TEST(WallFill, HasAsManyLayersAsTheKernelSees) {
    auto const c = tank(open_box);
    auto const walls = fill_walls<2>(c);
    // 3 layers (0.05, 0.15 and 0.25 m deep) around 10 x 10 lattice points, but in corners those farther than 0.27 m.
    EXPECT_EQ(fill<2>(c).size(), 100u);
    EXPECT_EQ(walls.size(), 4u * 30 + 4 * 6);
    for (std::size_t k = 0; k < walls.size(); ++k) {
        auto const x = walls.position[k], mirror = x + walls.to_mirror[k];
        for (int a = 0; a < 2; ++a) {  // a mirror in each wall that the point is behind
            double const reflected = x[a] < 0 ? -x[a] : x[a] > 1 ? 2 - x[a] : x[a];
            EXPECT_NEAR(mirror[a], reflected, 1e-12);
        }
    }
}

TEST(WallFill, LooksOutOfACornerOfTwoWallsThroughBoth) {
    // The same corner from two plates.
    auto const c = tank(
        "[[walls]]\nkind = 'box'\nsolid = 'inside'\ncentre = [-0.5, 0]\nsize = [1, 6]\n"
        "[[walls]]\nkind = 'box'\nsolid = 'inside'\ncentre = [0, -0.5]\nsize = [6, 1]\n");
    auto const walls = fill_walls<2>(c);
    std::size_t in_corner = 0;
    for (std::size_t k = 0; k < walls.size(); ++k) {
        auto const x = walls.position[k], mirror = x + walls.to_mirror[k];
        if (x[0] > 0 || x[1] > 0 || x[0] < -0.27 || x[1] < -0.27) continue;
        ++in_corner;
        EXPECT_NEAR(mirror[0], -x[0], 1e-12);
        EXPECT_NEAR(mirror[1], -x[1], 1e-12);
    }
    EXPECT_GT(in_corner, 3u);
}

TEST(WallFill, LooksOutBesideAnObstacleOnTheFloor) {
    // A block that stands on the floor: what is under it, or at its foot, looks out at its sides, and not into it.
    auto const c =
        tank(open_box + "[[walls]]\nkind = 'box'\nsolid = 'inside'\ncentre = [0.5, 0.2]\nsize = [0.4, 0.4]\n");
    auto const walls = fill_walls<2>(c);
    Solid<2> const solid(c);
    std::size_t under = 0;
    for (std::size_t k = 0; k < walls.size(); ++k) {
        auto const x = walls.position[k], mirror = x + walls.to_mirror[k];
        EXPECT_FALSE(solid.holds(mirror)) << x[0] << ' ' << x[1];
        EXPECT_GT(norm2(walls.to_mirror[k]), 0.01 * 0.01);
        under += x[0] > 0.3 && x[0] < 0.7 && x[1] < 0;
        if (std::fabs(x[0] - 0.35) < 1e-9 && std::fabs(x[1] - 0.05) < 1e-9) {  // its foot
            EXPECT_NEAR(mirror[0], 0.25, 1e-9);
            EXPECT_NEAR(mirror[1], 0.05, 1e-9);
        }
        if (std::fabs(x[0] - 0.35) < 1e-9 && std::fabs(x[1] + 0.05) < 1e-9) {  // below that, at the corner it makes
            EXPECT_NEAR(mirror[0], 0.25, 1e-9);
            EXPECT_NEAR(mirror[1], 0.05, 1e-9);
        }
    }
    EXPECT_GT(under, 0u);
}

TEST(WallFill, LooksOutOfAPlateThatGoesOnAcrossAPeriod) {
    auto const c = tank("[[walls]]\nkind = 'box'\nsolid = 'inside'\ncentre = [0.5, 0.5]\nsize = [1, 0.4]\n",
                        "[domain]\nperiodic = 'x'\ncentre = [0.5, 0]\nsize = [1, 1]\n");
    auto const walls = fill_walls<2>(c);
    EXPECT_EQ(walls.size(), 40u);
    for (std::size_t k = 0; k < walls.size(); ++k) {
        EXPECT_NEAR(walls.to_mirror[k][0], 0, 1e-9);
        EXPECT_GT(std::fabs(walls.position[k][1] + walls.to_mirror[k][1] - 0.5), 0.2);
    }
}

TEST(WallFill, KnowsThatNoWallMayBeAtRest) {
    auto const moving = tank(open_box + "displacement = ['0.1*t', 0]\n");
    EXPECT_FALSE(Solid<2>::at_rest(moving).holds({{-0.1, 0.5}}));
    EXPECT_TRUE(Solid<2>(moving).holds({{-0.1, 0.5}}));
    EXPECT_TRUE(Solid<2>::at_rest(tank(open_box)).holds({{-0.1, 0.5}}));
}

TEST(WallFill, LaysEveryPointOnceInAPeriodicBox) {
    auto const c = tank("[[walls]]\nkind = 'box'\ncentre = [0.5, 0.5]\nsize = [8, 1]\n",
                        "[domain]\nperiodic = 'x'\ncentre = [0.5, 0]\nsize = [1, 1]\n");
    EXPECT_EQ(fill<2>(c).size(), 100u);
    EXPECT_EQ(fill_walls<2>(c).size(), 2u * 3 * 10);
}

TEST(LatticeSlopeMoment, IsThatOfTheSums) {
    auto const c = tank("");
    Kernel const kernel = make_kernel("quintic-spline", 2, 0.39);
    double moment = 0;
    for (int a = -5; a <= 5; ++a)
        for (int b = -5; b <= 5; ++b) {
            double const x = 0.1 * a, r2 = x * x + 0.01 * b * b;
            moment -= 0.01 * kernel(r2).F * x * x;
        }
    EXPECT_NEAR(lattice_slope_moment<2>(c, kernel), moment, 1e-14);
    EXPECT_NEAR(moment, 1, 1e-3);
}

}  // namespace coronet
