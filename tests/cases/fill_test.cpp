// SPDX-License-Identifier: BSD-3-Clause

// Particles on lattices inside shapes: how many, where, and which stand at the surface.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/read.hpp"

namespace coronet {

namespace {

using Settings = std::vector<std::string>;

/// A liquid of the given shapes (a TOML list of inline tables) at spacing 0.1 m.
template <int D = 2>
Seeds<D> liquid(std::string const& shapes, Settings const& settings = {}) {
    std::string const text = "name = \"liquid\"\ndimension = " + std::to_string(D) + "\nshapes = " + shapes +
                             "\nparticles.spacing = 0.1\nfluid.density = 1000\nfluid.sound_speed = 10\ntime.end = 1\n";
    return fill<D>(read_case(text, "liquid", settings));
}

template <int D = 2>
Seeds<D> builtin(std::string const& name, Settings const& settings = {}) {
    return fill<D>(load_case(name, settings));
}

std::string const disc = "[{kind = \"disc\", radius = 1}]";
std::string const unit_box = "{kind = \"box\", size = [1, 1]}";

template <int D>
std::ptrdiff_t at_surface(Seeds<D> const& seeds) {
    return std::count_if(seeds.surface.begin(), seeds.surface.end(), [](char mark) { return mark != 0; });
}

/// The positions rounded to a millionth of the spacing, in an order that depends on them alone.
std::set<std::pair<long, long>> points(Seeds<2> const& seeds) {
    std::set<std::pair<long, long>> set;
    for (auto const& x : seeds.position) set.insert({std::lround(x[0] * 1e7), std::lround(x[1] * 1e7)});
    return set;
}

TEST(Fill, MakesAsManyParticlesAsThePapers) {
    EXPECT_EQ(builtin("drop-stretching", {"particles.spacing=0.04"}).size(), 1961u);
    EXPECT_EQ(builtin("drop-stretching", {"particles.spacing=0.02"}).size(), 7845u);
    EXPECT_EQ(builtin("square-patch").size(), 2601u);
    EXPECT_NEAR(static_cast<double>(builtin<3>("spheroid-stretching").size()), 30000, 100);
}

TEST(Fill, GivesParticlesOfADiscItsArea) {
    for (std::string const lattice : {"square", "hexagonal"})
        for (std::string const origin : {"node", "cell"}) {
            auto const seeds =
                liquid(disc, {"particles.spacing=0.02", "particles.lattice=" + lattice, "particles.origin=" + origin});
            double const area = static_cast<double>(seeds.size()) * seeds.volume;
            EXPECT_NEAR(area / std::numbers::pi, 1, 0.01) << lattice << ", " << origin;
        }
}

TEST(Fill, GivesParticlesOfABallItsVolume) {
    for (std::string const lattice : {"square", "hexagonal"}) {
        auto const seeds =
            liquid<3>("[{kind = \"ball\", radius = 1}]", {"particles.spacing=0.06", "particles.lattice=" + lattice});
        double const volume = static_cast<double>(seeds.size()) * seeds.volume;
        EXPECT_NEAR(volume / (4 * std::numbers::pi / 3), 1, 0.01) << lattice;
    }
}

TEST(Fill, KeepsLatticeNeighboursOneSpacingApartAndMarksParticlesThatMissSome) {
    auto const check = [](auto const& seeds, std::size_t most, std::string const& what) {
        double nearest2 = 1e9;
        std::size_t largest = 0;
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            std::size_t neighbours = 0;
            for (std::size_t j = 0; j < seeds.size(); ++j) {
                if (i == j) continue;
                double const r2 = norm2(seeds.position[i] - seeds.position[j]);
                nearest2 = std::min(nearest2, r2);
                neighbours += r2 < 0.101 * 0.101;
            }
            largest = std::max(largest, neighbours);
            EXPECT_EQ(seeds.surface[i] != 0, neighbours < most) << what;
        }
        EXPECT_NEAR(std::sqrt(nearest2), 0.1, 1e-12) << what;
        EXPECT_EQ(largest, most) << what;
    };
    std::string const ball = "[{kind = \"ball\", radius = 0.35}]";
    check(liquid(disc), 4, "square");
    check(liquid(disc, {"particles.lattice=hexagonal"}), 6, "hexagonal");
    check(liquid<3>(ball), 6, "cubic");
    check(liquid<3>(ball, {"particles.lattice=hexagonal"}), 12, "face-centred cubic");
}

TEST(Fill, MarksTheParticlesAtTheSurfaceOfASquare) {
    auto const seeds = builtin("square-patch");
    EXPECT_EQ(at_surface(seeds), 200);  // 51 x 51 less 49 x 49
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        bool const edge = std::max(std::fabs(seeds.position[i][0]), std::fabs(seeds.position[i][1])) > 0.98;
        EXPECT_EQ(seeds.surface[i] != 0, edge);
    }
}

TEST(Fill, MarksTheParticlesAtTheSurfaceOfADisc) {
    for (std::string const lattice : {"square", "hexagonal"}) {
        auto const seeds = liquid(disc, {"particles.spacing=0.04", "particles.lattice=" + lattice});
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            double const r = std::sqrt(norm2(seeds.position[i]));
            // Some lattice neighbour lies nearly straight outwards: at worst 45 degrees off, or 30.
            double const outwards =
                lattice == "square" ? std::cos(std::numbers::pi / 4) : std::cos(std::numbers::pi / 6);
            bool const must = r > 1 - 0.04 * outwards, must_not = r < 1 - 0.04;
            EXPECT_TRUE(seeds.surface[i] ? !must_not : !must) << lattice << " at r = " << r;
        }
        EXPECT_GT(at_surface(seeds), 2 * std::numbers::pi / 0.04 / 2) << lattice;
    }
}

TEST(Fill, PutsAParticleOrACellCornerAtTheOrigin) {
    auto const node = points(liquid(disc)), cell = points(liquid(disc, {"particles.origin=cell"}));
    EXPECT_TRUE(node.contains({0, 0}));
    EXPECT_FALSE(cell.contains({0, 0}));
    EXPECT_TRUE(cell.contains({500000, 500000}));
    EXPECT_TRUE(cell.contains({-500000, 500000}));
}

TEST(Fill, TurnsTheLatticeAndNotTheShape) {
    auto const straight = liquid(disc);
    auto const turned = liquid(disc, {"particles.rotation=30"});
    EXPECT_EQ(straight.size(), turned.size());
    double const c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    auto expected = straight;
    for (auto& x : expected.position) x = {{c * x[0] - s * x[1], s * x[0] + c * x[1]}};
    EXPECT_EQ(points(turned), points(expected));
    EXPECT_NE(points(turned), points(straight));

    EXPECT_EQ(points(liquid(disc, {"particles.rotation=90"})), points(straight));
    for (auto const& x : liquid("[" + unit_box + "]", {"particles.rotation=30"}).position)
        EXPECT_LE(std::max(std::fabs(x[0]), std::fabs(x[1])), 0.5 + 1e-9);
}

TEST(Fill, TurnsTheShapeAndNotTheLattice) {
    std::string const bar = "[{kind = \"box\", size = [2, 0.2], rotation = 90}]";
    EXPECT_EQ(points(liquid(bar)), points(liquid("[{kind = \"box\", size = [0.2, 2]}]")));
    std::string const ellipse = "[{kind = \"ellipse\", semi_axes = [1, 0.25], rotation = -90}]";
    EXPECT_EQ(points(liquid(ellipse)), points(liquid("[{kind = \"ellipse\", semi_axes = [0.25, 1]}]")));

    auto const diagonal = liquid("[{kind = \"box\", size = [2, 0.1], rotation = 45}]");
    EXPECT_EQ(diagonal.size(), 15u);  // x = y = -0.7 ... 0.7
    for (auto const& x : diagonal.position) EXPECT_NEAR(x[0], x[1], 1e-12);
}

TEST(Fill, TriesEveryPointOfALongTurnedShape) {
    auto const seeds = liquid("[{kind = \"box\", size = [3, 0.5], rotation = 20, centre = [7, -4]}]",
                              {"particles.lattice=hexagonal", "particles.rotation=50", "particles.spacing=0.01"});
    EXPECT_NEAR(static_cast<double>(seeds.size()) * seeds.volume, 1.5, 0.015);
}

TEST(Fill, MovesParticlesAtRandomAndAlwaysTheSame) {
    auto const straight = liquid(disc), once = liquid(disc, {"particles.jitter=0.2"}),
               again = liquid(disc, {"particles.jitter=0.2"}),
               other = liquid(disc, {"particles.jitter=0.2", "particles.seed=2"});
    ASSERT_EQ(once.size(), straight.size());
    double largest = 0, mean = 0;
    for (std::size_t i = 0; i < once.size(); ++i)
        for (int k = 0; k < 2; ++k) {
            double const moved = once.position[i][k] - straight.position[i][k];
            EXPECT_EQ(once.position[i][k], again.position[i][k]);
            EXPECT_NE(once.position[i][k], other.position[i][k]);
            largest = std::max(largest, std::fabs(moved));
            mean += moved / static_cast<double>(2 * once.size());
        }
    EXPECT_LE(largest, 0.2 * 0.1);
    EXPECT_GT(largest, 0.95 * 0.2 * 0.1);
    EXPECT_LT(std::fabs(mean), 0.2 * 0.1 * 0.1);  // 634 even numbers: their mean is within 4.4 standard deviations
    EXPECT_EQ(once.surface, straight.surface);
}

TEST(Fill, TakesTheCutsAway) {
    auto const whole = liquid("[" + unit_box + "]");
    EXPECT_EQ(whole.size(), 11u * 11u);
    std::string const half = "{kind = \"box\", size = [1, 1], cuts = [{normal = [1, 0]}]}";
    EXPECT_EQ(liquid("[" + half + "]").size(), 6u * 11u);  // the cutting plane itself stays
    std::string const quarter =
        "{kind = \"box\", size = [1, 1], cuts = [{normal = [3, 0]}, {point = [0, 0.2], normal = [0, -1]}]}";
    auto const corner = liquid("[" + quarter + "]");
    EXPECT_EQ(corner.size(), 6u * 4u);
    for (auto const& x : corner.position) EXPECT_TRUE(x[0] < 1e-9 && x[1] > 0.2 - 1e-9);
    EXPECT_EQ(at_surface(corner), 24 - 4 * 2);  // cutting makes a surface
}

TEST(Fill, CountsParticlesOfOverlappingShapesOnce) {
    std::string const right = "{kind = \"box\", size = [1, 1], centre = [0.5, 0]}";
    auto const both = liquid("[" + unit_box + ", " + right + "]");
    EXPECT_EQ(both.size(), 16u * 11u);
    EXPECT_EQ(points(both).size(), both.size());
    EXPECT_EQ(points(both), points(liquid("[" + right + ", " + unit_box + "]")));
    EXPECT_EQ(at_surface(both), 16 * 11 - 14 * 9);  // none inside, where one shape ends in the other
}

TEST(Fill, OfShapesFarApartIsTheirSum) {
    std::string const far = "{kind = \"box\", size = [1, 1], centre = [1e6, 1e6]}";
    EXPECT_EQ(liquid("[" + unit_box + ", " + far + "]").size(), 2u * 11u * 11u);
}

TEST(ExpectedParticles, AreNearTheParticlesThatFillMakes) {
    auto const compare = [](std::string const& shape, Settings const& settings) {
        std::string const text =
            "name = \"one\"\ndimension = 2\nshapes = [" + shape +
            "]\nparticles.spacing = 0.01\nfluid.density = 1\nfluid.sound_speed = 10\ntime.end = 1\n";
        Case const c = read_case(text, "one", settings);
        return expected_particles<2>(c) / static_cast<double>(fill<2>(c).size());
    };
    EXPECT_NEAR(compare("{kind = \"box\", size = [5, 0.2]}", {}), 1, 0.06);
    EXPECT_NEAR(compare("{kind = \"disc\", radius = 1}", {}), 4 / std::numbers::pi, 0.01);
    EXPECT_NEAR(compare("{kind = \"disc\", radius = 1}", {"particles.lattice=hexagonal"}), 4 / std::numbers::pi, 0.01);
}

}  // namespace

}  // namespace coronet
