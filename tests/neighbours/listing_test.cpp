// SPDX-License-Identifier: BSD-3-Clause

// When the lists are kept and when they are made anew: kept lists must still hold all pairs within the
// support.
#include "coronet/neighbours/neighbours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/neighbours/points.hpp"

namespace {

using namespace coronet;
using namespace coronet::test;

TEST(Neighbours, StayListedWhileNoTwoParticlesMoveTheSkinApart) {
    in_every_dimension([]<int D>() {
        std::mt19937 engine(2);
        std::normal_distribution<double> normal;
        auto const direction = [&] {
            Vector<double, D> v;
            for (double& c : v.c) c = normal(engine);
            return (1 / std::sqrt(norm2(v))) * v;
        };
        double const support = 0.3, skin = 0.05;
        auto particles = particles_at<D>(cloud<D>(300));
        Neighbours<D> neighbours(support, skin);
        neighbours.update(particles);
        auto const start = points_of(particles);
        for (int repetition = 0; repetition < 10; ++repetition) {
            // Every second particle goes where the one before it does not: the mean stays where it is.
            Vector<double, D> step;
            for (std::size_t i = 0; i < start.size(); ++i) {
                if (i % 2 == 0) step = direction();
                double const length = (i % 2 == 0 ? 1 : -1) * 0.499 * skin / std::sqrt(D);
                particles.view().template set<Position>(i, start[i] + length * step);
            }
            EXPECT_FALSE(neighbours.update(particles));
            expect_listed(particles, neighbours, support, support + 2 * skin);
        }
        EXPECT_EQ(neighbours.listings(), 1u);
    });
}

/// Two particles just out of reach of each other, both moved towards the other by a share of the skin.
template <int D>
bool lists_anew(int axis, double share, double other_share) {
    auto particles = particles_at<D>({along<D>(axis, 0), along<D>(axis, 1.1001)});
    Neighbours<D> neighbours(1, 0.1);
    neighbours.update(particles);
    move(particles, [&](auto id) { return along<D>(axis, id == 0 ? share * 0.1 : -other_share * 0.1); });
    bool const anew = neighbours.update(particles);
    EXPECT_EQ(neighbours.listings(), anew ? 2u : 1u);
    expect_listed(particles, neighbours, 1, anew ? 1.1 : 1.2);
    return anew;
}

TEST(Neighbours, AreListedAnewOnceTwoParticlesMayHaveComeTheSkinCloser) {
    in_every_dimension([]<int D>() {
        for (int axis = 0; axis < D; ++axis) {
            EXPECT_FALSE(lists_anew<D>(axis, 0.499, 0.499));
            EXPECT_TRUE(lists_anew<D>(axis, 0.501, 0.501));
            EXPECT_FALSE(lists_anew<D>(axis, 0.999, 0));  // one alone may take the whole skin
            EXPECT_TRUE(lists_anew<D>(axis, 1.001, 0));
        }
    });
}

TEST(Neighbours, AreListedAnewWhenOneOfManyMovesTheSkin) {
    in_every_dimension([]<int D>() {
        for (double const share : {0.99, 1.01}) {
            auto particles = particles_at<D>(cloud<D>(1000));
            Neighbours<D> neighbours(0.1, 0.01);
            neighbours.update(particles);
            move(particles, [&](auto id) { return along<D>(D - 1, id == 500 ? share * 0.01 : 0); });
            EXPECT_EQ(neighbours.update(particles), share > 1);
            if (share > 1) expect_all_pairs(particles, neighbours, 0.11);
        }
    });
}

TEST(Neighbours, AreCountedFromTheLastListing) {
    // Two halves part by 0.6 of the skin, four times: the second and the fourth pass it since the listing before.
    auto particles = particles_at<2>(cloud<2>(400));
    Neighbours<2> neighbours(0.2, 0.04);
    neighbours.update(particles);
    for (bool const expected : {false, true, false, true}) {
        move(particles, [](auto id) { return along<2>(0, id % 2 == 0 ? 0.3 * 0.04 : -0.3 * 0.04); });
        EXPECT_EQ(neighbours.update(particles), expected);
        expect_listed(particles, neighbours, 0.2, 0.32);
    }
    EXPECT_EQ(neighbours.listings(), 3u);
}

TEST(Neighbours, StayListedInAFlowThatIsSmooth) {
    // Stretched by 2 %, the ends of the cloud part by four times the skin, but no two particles that can meet do.
    in_every_dimension([]<int D>() {
        auto particles = particles_at<D>(cloud<D>(5000));
        Neighbours<D> neighbours(0.05, 0.01);
        neighbours.update(particles);
        auto const start = points_of(particles);
        for (std::size_t i = 0; i < start.size(); ++i)
            particles.view().template set<Position>(i, start[i] + along<D>(D - 1, 0.02 * start[i][D - 1]));
        EXPECT_FALSE(neighbours.update(particles));
        expect_listed(particles, neighbours, 0.05, 0.07);
    });
}

TEST(Neighbours, AreListedAnewWhenSomethingComesFromFarAway) {
    // Two groups, each rigid, that meet: within a group displacements are the same.
    in_every_dimension([]<int D>() {
        auto points = cloud<D>(200);
        for (std::size_t i = 0; i < 100; ++i) points[i] = points[i] + along<D>(0, 7);
        auto particles = particles_at<D>(points);
        Neighbours<D> neighbours(0.1, 0.01);
        neighbours.update(particles);
        bool anew = false;
        for (int step = 0; step < 80; ++step) {
            move(particles, [](auto id) { return along<D>(0, id < 100 ? -0.1 : 0); });
            anew = neighbours.update(particles) || anew;
            expect_listed(particles, neighbours, 0.1, 0.3);
        }
        EXPECT_TRUE(anew);
    });
}

TEST(Neighbours, WithATunedSkinHoldAllPairsAndAreListedLessOftenInSlowFlow) {
    auto const listings = [](double speed) {
        auto particles = particles_at<2>(cloud<2>(1000));
        Neighbours<2> neighbours(0.1, 0.005, 1);
        for (int step = 0; step < 100; ++step) {
            move(particles, [=](auto id) { return along<2>(0, (id % 2 == 0 ? speed : -speed) * 0.1); });
            neighbours.update(particles);
            expect_listed(particles, neighbours, 0.1, 0.1 + 2.1 * neighbours.skin());
        }
        return neighbours.listings();
    };
    auto const slow = listings(1e-4), fast = listings(1e-2);
    EXPECT_LT(slow, 6u);
    EXPECT_GT(fast, 2 * slow);
    EXPECT_LT(fast, 60u);
}

TEST(Neighbours, WithATunedSkinDoNotCareHowOftenTheyAreLookedAt) {
    auto const skin = [](int looks) {
        auto particles = particles_at<2>(cloud<2>(500));
        Neighbours<2> neighbours(0.1, 0.005, 1);
        for (int step = 0; step < 40; ++step) {
            move(particles, [=](auto id) { return along<2>(0, id % 2 == 0 ? 5e-4 : -5e-4); });
            for (int look = 0; look < looks; ++look) neighbours.update(particles);
        }
        return neighbours.skin();
    };
    EXPECT_EQ(skin(3), skin(1));
    EXPECT_NE(skin(1), 0.005);
}

TEST(Neighbours, WithoutASkinAreAlwaysListedAnew) {
    auto particles = particles_at<2>(cloud<2>(100));
    Neighbours<2> neighbours(0.3, 0);
    for (int repetition = 0; repetition < 3; ++repetition) EXPECT_TRUE(neighbours.update(particles));
    expect_all_pairs(particles, neighbours, 0.3);
}

TEST(Neighbours, StayListedWhenAllMoveAlike) {
    in_every_dimension([]<int D>() {
        auto particles = particles_at<D>(cloud<D>(300));
        Neighbours<D> neighbours(0.3, 0.03);
        neighbours.update(particles);
        for (int repetition = 0; repetition < 5; ++repetition) {
            move(particles, [](auto) { return along<D>(0, 0.7) + along<D>(D - 1, -12.3); });
            EXPECT_FALSE(neighbours.update(particles));
        }
        EXPECT_EQ(neighbours.listings(), 1u);
        expect_all_pairs(particles, neighbours, 0.33);
    });
}

}  // namespace
