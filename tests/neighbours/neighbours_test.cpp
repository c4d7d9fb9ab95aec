// SPDX-License-Identifier: BSD-3-Clause

// A pair whose distance is the reach but for rounding may be listed or not; all others are known.
#include "coronet/neighbours/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "coronet/core/error.hpp"
#include "tests/neighbours/points.hpp"

namespace {

using namespace coronet;
using namespace coronet::test;

/// Lists the neighbours of particles at these points, which must be neither lost nor changed by it.
template <int D>
void expect_found(Points<D> const& points, double support, double skin) {
    auto particles = particles_at<D>(points);
    Neighbours<D> neighbours(support, skin);
    EXPECT_TRUE(neighbours.update(particles));
    EXPECT_EQ(neighbours.listings(), 1u);
    expect_all_pairs(particles, neighbours, support + skin);
    auto ids = particles.id;
    auto const moved = points_of(particles);
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto const id = static_cast<std::size_t>(particles.id[i]);
        ASSERT_EQ(norm2(moved[i] - points[id]), 0);
        ASSERT_EQ(particles.template get<Mass>()[i], static_cast<double>(id));
    }
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 0; i < ids.size(); ++i) ASSERT_EQ(ids[i], static_cast<std::int64_t>(i));
}

TEST(Neighbours, InACloudAreThoseOfAllPairs) {
    in_every_dimension([]<int D>() {
        for (std::size_t const count : {0, 1, 2, 3, 7, 8, 9, 257, 400})
            for (double const support : {0.01, 0.15, 0.5, 4.0}) expect_found(cloud<D>(count), support, 0.1 * support);
    });
}

TEST(Neighbours, OnALatticeAreThoseOfAllPairs) {
    in_every_dimension([]<int D>() {
        for (double const support : {0.9, 1.5, 2.7, 3.0}) expect_found(lattice<D>(7, 0.1), 0.1 * support, 0.01);
    });
}

TEST(Neighbours, InAClusterAreThoseOfAllPairs) {
    in_every_dimension([]<int D>() { expect_found(cluster<D>(400), 0.1, 0.01); });
}

TEST(Neighbours, AreFoundWhereverTheOriginIs) {
    in_every_dimension([]<int D>() {
        for (double const origin : {-1e3, 1e3}) {
            auto points = cloud<D>(100);
            for (auto& x : points)
                for (double& c : x.c) c += origin;
            expect_found(points, 0.3, 0.03);
        }
    });
}

TEST(Neighbours, AreFoundWhenOneParticleIsVeryFarAway) {
    in_every_dimension([]<int D>() {
        for (int axis = 0; axis < D; ++axis)
            for (double const distance : {-1e6, 1e6, 1e15}) {
                auto points = cloud<D>(100);
                points[50] = along<D>(axis, distance);
                expect_found(points, 0.3, 0.03);
            }
        auto points = cloud<D>(100);
        for (double& c : points[50].c) c = 1e6;  // far along all axes at once
        expect_found(points, 0.3, 0.03);
    });
}

TEST(Neighbours, OfCoincidentParticlesAreAllOthers) {
    in_every_dimension([]<int D>() {
        for (std::size_t const count : {2, 9, 300}) expect_found(Points<D>(count, along<D>(0, 0.3)), 0.1, 0.01);
    });
}

TEST(Neighbours, OfASingleParticleAreNone) {
    in_every_dimension([]<int D>() {
        auto particles = particles_at<D>({along<D>(0, 5)});
        Neighbours<D> neighbours(1, 0.1);
        neighbours.update(particles);
        EXPECT_TRUE(neighbours.row(0).empty());
        EXPECT_FALSE(neighbours.update(particles));
    });
}

TEST(Neighbours, OfTwoParticlesAreEachOtherWithinTheReach) {
    in_every_dimension([]<int D>() {
        for (double const distance : {1.09, 1.11}) {
            auto particles = particles_at<D>({along<D>(0, 5), along<D>(0, 5 + distance)});
            Neighbours<D> neighbours(1, 0.1);
            neighbours.update(particles);
            std::size_t const expected = distance < 1.1 ? 1 : 0;
            EXPECT_EQ(neighbours.row(0).size(), expected);
            EXPECT_EQ(neighbours.row(1).size(), expected);
            EXPECT_EQ(neighbours.support(), 1);
        }
    });
}

/// What is said when particle 123 is put where it cannot be, before its first listing or after it.
template <int D>
std::string refusal_of(double nowhere, int axis, bool listed_before) {
    auto particles = particles_at<D>(cloud<D>(300));
    Neighbours<D> neighbours(0.3, 0.03);
    if (listed_before) neighbours.update(particles);
    auto const& id = particles.id;
    auto const place = static_cast<std::size_t>(std::find(id.begin(), id.end(), 123) - id.begin());
    particles.template get<Position>(axis)[place] = nowhere;
    try {
        neighbours.update(particles);
    } catch (RunError const& error) {
        return error.what();
    }
    return "nothing";
}

TEST(Neighbours, OfAPositionThatIsNotFiniteAreRefusedByTheParticlesNumber) {
    in_every_dimension([]<int D>() {
        for (double const nowhere : std::vector<double>{NAN, INFINITY, -INFINITY})
            for (int axis = 0; axis < D; ++axis)
                for (bool const listed_before : {false, true}) {
                    auto const said = refusal_of<D>(nowhere, axis, listed_before);
                    EXPECT_NE(said.find("particle 123 "), std::string::npos) << nowhere << " gives: " << said;
                }
    });
}

TEST(Neighbours, AreTheSameForAnyNumberOfThreads) {
    int const before = threads();
    in_every_dimension([]<int D>() {
        auto const listed = [](int threads) {
            set_threads(threads);
            auto particles = particles_at<D>(cloud<D>(5000));
            Neighbours<D> neighbours(0.15, 0.02);
            neighbours.update(particles);
            std::vector<std::vector<Index>> rows;
            for (std::size_t i = 0; i < particles.size(); ++i)
                rows.emplace_back(neighbours.row(i).begin(), neighbours.row(i).end());
            return std::tuple{particles.id, rows, neighbours.all().begin};
        };
        auto const alone = listed(1);
        EXPECT_EQ(listed(2), alone);
        EXPECT_EQ(listed(3), alone);
    });
    set_threads(before);
}

TEST(Neighbours, ListedTwiceLeaveTheOrderOfTheParticles) {
    in_every_dimension([]<int D>() {
        auto particles = particles_at<D>(cluster<D>(3000));
        Neighbours<D>(0.1, 0.01).update(particles);
        auto const order = particles.id;
        Neighbours<D>(0.1, 0.01).update(particles);
        EXPECT_EQ(particles.id, order);
    });
}

TEST(Neighbours, NearInSpaceAreNearInMemory) {
    // A shuffled line of particles is put in order but within cells, of 11 particles each.
    std::mt19937 engine(1);
    auto points = lattice<1>(1000, 0.1);
    std::shuffle(points.begin(), points.end(), engine);
    auto particles = particles_at<1>(points);
    Neighbours<1> neighbours(1, 0.1);
    neighbours.update(particles);
    auto const x = particles.get<Position>();
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], 0.1 * static_cast<double>(i), 1.1);
}

}  // namespace
