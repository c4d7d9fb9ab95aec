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

TEST(Neighbours, StayListedWhileNoParticleMovesHalfTheSkin) {
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
                double const length = (i % 2 == 0 ? 1 : -1) * 0.499 * skin;
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

TEST(Neighbours, AreListedAnewWhenOneOfManyMovesHalfTheSkin) {
    in_every_dimension([]<int D>() {
        for (double const share : {0.49, 0.51}) {
            auto particles = particles_at<D>(cloud<D>(1000));
            Neighbours<D> neighbours(0.1, 0.01);
            neighbours.update(particles);
            // The mean moves by a thousandth of it.
            move(particles, [&](auto id) { return along<D>(D - 1, id == 500 ? share * 0.01 : 0); });
            EXPECT_EQ(neighbours.update(particles), share > 0.5);
            if (share > 0.5) expect_all_pairs(particles, neighbours, 0.11);
        }
    });
}

TEST(Neighbours, AreCountedFromTheLastListing) {
    // Four moves of 0.3 of the skin: the second and the fourth pass half of it since the listing before.
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
