// SPDX-License-Identifier: BSD-3-Clause

// Periodic boundaries and walls, as neighbour lists see them.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

namespace {

constexpr double support = 0.2;

PeriodicBox<2> unit_box() {
    PeriodicBox<2> box;
    box.low = {{-0.5, 2}};
    box.size = {{1, 1}};
    box.periodic[0] = box.periodic[1] = true;
    return box;
}

/// Liquid at pseudo-random places in the box, some of it beyond its edges, and a few wall particles with their mirrors.
Particles<2> scattered(std::size_t liquid, std::size_t walls) {
    Particles<2> particles(liquid, walls);
    particles.allocate(Fields<Position, Velocity, PositionBefore>{});
    auto const view = particles.view();
    double a = 0.3, b = 0.7;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        a = std::fmod(a + 0.754877666, 1.0);
        b = std::fmod(b + 0.569840296, 1.0);
        view.set<Position>(i, {{1.2 * a - 0.6, 1.9 + 1.2 * b}});
        view.set<PositionBefore>(i, view.get<Position>(i) - Vector<double, 2>{{0.01, 0.02}});
    }
    return particles;
}

/// Identities of all neighbours of a particle, from the lists.
std::map<std::int64_t, std::vector<std::int64_t>> listed(Particles<2> const& particles,
                                                         Neighbours<2> const& neighbours) {
    std::map<std::int64_t, std::vector<std::int64_t>> rows;
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.end(Role::mirror); ++i) {
        auto& row = rows[particles.id[i]];
        for (Index const j : neighbours.row(i)) {
            auto const k = static_cast<std::size_t>(j);
            if (norm2(view.get<Position>(i) - view.get<Position>(k)) < support * support)
                row.push_back(particles.id[k]);
        }
        std::sort(row.begin(), row.end());
    }
    return rows;
}

/// The same from all pairs and the nearest of their images.
std::map<std::int64_t, std::vector<std::int64_t>> all_pairs(Particles<2> const& particles, PeriodicBox<2> const& box) {
    std::map<std::int64_t, std::vector<std::int64_t>> rows;
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.end(Role::mirror); ++i) {
        auto& row = rows[particles.id[i]];
        Role const own = particles.role(i);
        for (std::size_t j = 0; j < particles.end(own == Role::liquid ? Role::wall : Role::liquid); ++j) {
            auto d = view.get<Position>(i) - view.get<Position>(j);
            for (int k = 0; k < 2; ++k) d[k] -= box.size[k] * std::round(d[k] / box.size[k]);
            if (i != j && norm2(d) < support * support) row.push_back(particles.id[j]);
        }
        std::sort(row.begin(), row.end());
    }
    return rows;
}

}  // namespace

TEST(PeriodicBox, GivesEveryParticleTheNeighboursBeyondItsEdges) {
    auto particles = scattered(500, 60);
    Neighbours<2> neighbours(support, 0.02, 0, unit_box());
    EXPECT_TRUE(neighbours.update(particles));
    EXPECT_GT(particles.count(Role::liquid_image), 0u);
    EXPECT_GT(particles.count(Role::wall_image), 0u);
    EXPECT_EQ(listed(particles, neighbours), all_pairs(particles, unit_box()));
}

TEST(PeriodicBox, TakesParticlesInWithTheStepTheyAreIn) {
    auto particles = scattered(200, 0);
    Neighbours<2> neighbours(support, 0.02, 0, unit_box());
    neighbours.update(particles);
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        auto const x = view.get<Position>(i);
        EXPECT_GE(x[0], -0.5);
        EXPECT_LT(x[0], 0.5);
        EXPECT_GE(x[1], 2);
        EXPECT_LT(x[1], 3);
        EXPECT_NEAR(x[0] - view.get<PositionBefore>(i)[0], 0.01, 1e-15);
        EXPECT_NEAR(x[1] - view.get<PositionBefore>(i)[1], 0.02, 1e-15);
    }
}

TEST(Images, MoveWithTheirOriginals) {
    auto particles = scattered(500, 60);
    Neighbours<2> neighbours(support, 0.05, 0, unit_box());
    neighbours.update(particles);
    auto const view = particles.view();
    // Every particle a little in a direction of its own: the old rows must still do.
    for (std::size_t i = 0; i < particles.owned(); ++i)
        view.set<Position>(i, view.get<Position>(i) + 0.01 * Vector<double, 2>{{std::sin(1.0 * i), std::cos(1.0 * i)}});
    for (std::size_t i = 0; i < particles.end(Role::wall); ++i) {
        double const id = static_cast<double>(particles.id[i]);
        view.set<Velocity>(i, {{id, -id}});
    }
    EXPECT_FALSE(neighbours.update(particles));
    neighbours.images().refresh(particles, Fields<Velocity>{});
    EXPECT_EQ(listed(particles, neighbours), all_pairs(particles, unit_box()));
    for (std::size_t i = particles.begin(Role::liquid_image); i < particles.size(); ++i)
        EXPECT_EQ(view.get<Velocity>(i)[0], static_cast<double>(particles.id[i]));
}

TEST(Images, HaveTheMassOfTheirOriginals) {
    auto particles = scattered(300, 0);
    particles.allocate(Fields<Mass>{});
    for (std::size_t i = 0; i < particles.size(); ++i) particles.view().at<Mass>()[i] = 1.0 + static_cast<double>(i);
    Neighbours<2> neighbours(support, 0, 0, unit_box());
    neighbours.update(particles);
    auto const view = particles.view();
    ASSERT_GT(particles.size(), particles.owned());
    for (std::size_t i = 0; i < particles.size(); ++i)
        EXPECT_EQ(view.at<Mass>()[i], 1.0 + static_cast<double>(particles.id[i]));
}

TEST(Images, ThatComeCloserMakeListsAnew) {
    // Two particles that meet through the edge alone.
    Particles<2> particles(2);
    particles.allocate(Fields<Position>{});
    auto const view = particles.view();
    view.set<Position>(0, {{-0.49, 2.5}});
    view.set<Position>(1, {{0.263, 2.5}});
    Neighbours<2> neighbours(support, 0.02, 0, unit_box());
    neighbours.update(particles);
    for (int step = 0; step < 20; ++step) {
        for (std::size_t i = 0; i < 2; ++i)
            if (particles.id[i] == 1) particles.view().set<Position>(i, {{0.263 + 0.01 * step, 2.5}});
        neighbours.update(particles);
        EXPECT_EQ(listed(particles, neighbours), all_pairs(particles, unit_box())) << step;
    }
}

}  // namespace coronet
