// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/core/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "coronet/core/tensor.hpp"

namespace {

using coronet::items_per_block;

class Parallel : public ::testing::Test {
protected:
    void TearDown() override { coronet::set_threads(before); }

    int const before = coronet::threads();
};

constexpr std::size_t sizes[] = {0, 1, 2, items_per_block - 1, items_per_block, items_per_block + 1, 100'001};

/// Numbers of sizes from 1e-8 to 1e8, each with its negative somewhere: what a sum in some order gives is its
/// rounding.
std::vector<double> uneven_numbers(std::size_t size) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> exponent(-8, 8);
    std::vector<double> numbers(size);
    for (std::size_t i = 0; i < size; ++i)
        numbers[i] = i % 2 == 0 ? std::pow(10, exponent(engine)) : -numbers[i - 1];
    std::shuffle(numbers.begin(), numbers.end(), engine);
    return numbers;
}

TEST_F(Parallel, LoopDoesEachItemOnce) {
    for (int const threads : {1, 2, 3})
        for (std::size_t const size : sizes) {
            coronet::set_threads(threads);
            std::vector<std::atomic<int>> done(size);
            coronet::for_each(size, [&](std::size_t i) { ++done[i]; });
            for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(done[i], 1) << i << " of " << size;
        }
}

TEST_F(Parallel, RangesCoverEachItemOnceAndNoneIsLong) {
    for (std::size_t const size : sizes) {
        coronet::set_threads(2);
        std::vector<std::atomic<int>> done(size);
        coronet::for_ranges(size, [&](std::size_t first, std::size_t last) {
            EXPECT_LT(first, last);
            EXPECT_LE(last - first, items_per_block);
            for (std::size_t i = first; i < last; ++i) ++done[i];
        });
        for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(done[i], 1) << i << " of " << size;
    }
}

TEST_F(Parallel, SumHasTheSameBitsForAnyNumberOfThreads) {
    for (std::size_t const size : sizes) {
        auto const x = uneven_numbers(size);
        auto const sum = [&](int threads) {
            coronet::set_threads(threads);
            return std::bit_cast<std::uint64_t>(coronet::sum_over(size, 0.0, [&](std::size_t i) {
                // With a second thread the first block ends after others.
                if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
                return x[i];
            }));
        };
        auto const alone = sum(1);
        for (int repetition = 0; repetition < 5; ++repetition)
            for (int const threads : {2, 3}) EXPECT_EQ(sum(threads), alone) << size;
    }
}

TEST_F(Parallel, SumIsTheSum) {
    for (std::size_t const size : sizes) {
        auto const x = uneven_numbers(size);
        long double exact = 0, parts = 0;
        for (double const value : x) {
            exact += value;
            parts += std::fabs(value);
        }
        // Blocks bound the depth of the additions, to the items of one block and the blocks.
        auto const additions = static_cast<double>(items_per_block + size / items_per_block);
        double const rounding = additions * std::numeric_limits<double>::epsilon() * static_cast<double>(parts);
        double const sum = coronet::sum_over(size, 0.0, [&](std::size_t i) { return x[i]; });
        EXPECT_NEAR(sum, static_cast<double>(exact), rounding) << size;
        auto const vectors = coronet::sum_over(size, coronet::Vector<double, 2>{}, [&](std::size_t i) {
            return coronet::Vector<double, 2>{{x[i], 1}};
        });
        EXPECT_EQ(vectors[0], sum);
        EXPECT_EQ(vectors[1], static_cast<double>(size));
    }
}

TEST_F(Parallel, ExtremesAreFoundWhereverTheyStand) {
    coronet::set_threads(2);
    for (std::size_t const size : sizes) {
        if (size == 0) continue;
        auto const noise = uneven_numbers(size);
        for (std::size_t const place : {std::size_t{0}, size / 2, size - 1}) {
            auto x = noise;
            x[place] = 1e9;
            EXPECT_EQ(coronet::max_over(size, -INFINITY, [&](std::size_t i) { return x[i]; }), 1e9);
            EXPECT_EQ(coronet::min_over(size, INFINITY, [&](std::size_t i) { return -x[i]; }), -1e9);
        }
    }
}

TEST_F(Parallel, ExtremesOfNothingAreWhatTheyStartFrom) {
    auto const never = [](std::size_t) { return NAN; };
    EXPECT_EQ(coronet::max_over(0, 3, never), 3);
    EXPECT_EQ(coronet::min_over(0, 3, never), 3);
    EXPECT_EQ(coronet::sum_over(0, 0.0, never), 0);
    EXPECT_EQ(coronet::max_over(9, 3, [](std::size_t) { return 2; }), 3);
    EXPECT_EQ(coronet::min_over(9, 3, [](std::size_t) { return 4; }), 3);
}

TEST_F(Parallel, ThreadsAreAsManyAsAskedFor) {
    for (int const asked : {1, 2, 3}) {
        coronet::set_threads(asked);
        EXPECT_EQ(coronet::threads(), asked);
    }
    coronet::set_threads(0);
    EXPECT_GE(coronet::threads(), 1);
}

}  // namespace
