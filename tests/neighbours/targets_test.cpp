// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/neighbours/neighbours.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <vector>

#include "tests/neighbours/points.hpp"

namespace {

using namespace coronet;
using namespace coronet::test;

/// Each particle of `wanted` stands in one block, in order; blocks are neither empty nor of many more pairs
/// than asked.
template <int D>
void expect_blocks(Targets const& targets, Neighbours<D> const& neighbours, std::vector<std::size_t> const& wanted) {
    std::size_t const block_of_pairs = 4096;
    std::vector<std::size_t> covered;
    ASSERT_EQ(targets.begin.front(), 0u);
    for (std::size_t block = 0; block < targets.blocks(); ++block) {
        EXPECT_LT(targets.begin[block], targets.begin[block + 1]);
        std::size_t pairs = 0, longest = 0;
        for (std::size_t k = targets.begin[block]; k < targets.begin[block + 1]; ++k) {
            covered.push_back(targets[k]);
            pairs += neighbours.row(targets[k]).size() + 1;
            longest = std::max<std::size_t>(longest, neighbours.row(targets[k]).size());
        }
        EXPECT_LT(pairs, block_of_pairs + longest + 1);
        bool const last = block + 1 == targets.blocks();
        EXPECT_TRUE(last || pairs >= block_of_pairs) << pairs;
    }
    EXPECT_EQ(covered, wanted);
}

TEST(Targets, StandEachInOneBlockOfAboutEqualPairs) {
    in_every_dimension([]<int D>() {
        for (std::size_t const count : {0, 1, 2, 300, 3000}) {
            auto particles = particles_at<D>(cluster<D>(count));
            Neighbours<D> neighbours(0.1, 0.01);
            neighbours.update(particles);
            std::vector<std::size_t> all(count), even, none;
            std::iota(all.begin(), all.end(), 0);
            for (std::size_t i = 0; i < count; i += 2) even.push_back(i);
            expect_blocks(neighbours.all(), neighbours, all);
            expect_blocks(neighbours.targets([](std::size_t) { return true; }), neighbours, all);
            expect_blocks(neighbours.targets([](std::size_t i) { return i % 2 == 0; }), neighbours, even);
            expect_blocks(neighbours.targets([](std::size_t) { return false; }), neighbours, none);
        }
    });
}

TEST(Targets, AreCutAnewWithEveryListing) {
    auto particles = particles_at<2>(cloud<2>(3000));
    Neighbours<2> neighbours(0.3, 0.03);
    std::vector<std::size_t> all(3000);
    std::iota(all.begin(), all.end(), 0);
    for (int repetition = 0; repetition < 2; ++repetition) {
        EXPECT_TRUE(neighbours.update(particles));
        EXPECT_GT(neighbours.all().blocks(), 1u);
        expect_blocks(neighbours.all(), neighbours, all);
        move(particles, [](auto id) { return along<2>(0, id % 2 == 0 ? 0.1 : 0); });
    }
}

}  // namespace
