// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/benchmark.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coronet/cases/choices.hpp"
#include "coronet/core/parallel.hpp"

namespace coronet {

namespace {

TEST(Benchmark, ReturnsNumbersThatFitEachOther) {
    set_threads(1);
    for (int const dimension : {2, 3})
        for (std::string const& gradient : choices_of("method.gradient"))
            for (std::string const& precision : choices_of("method.precision")) {
                SCOPED_TRACE(std::to_string(dimension) + "D " + gradient + " " + precision);
                auto const result = run_benchmark({dimension, gradient, precision, 1e3, 3, 1});
                EXPECT_NEAR(static_cast<double>(result.particles), 1000, 100);
                EXPECT_EQ(result.threads, 1);
                EXPECT_EQ(result.evaluations, 2 * 3);
                EXPECT_GT(result.neighbours, dimension == 2 ? 35 : 50);
                EXPECT_LT(result.neighbours, dimension == 2 ? 50 : 80);
                double seconds = 0;
                for (auto const& phase : result.seconds) seconds += phase.second;
                EXPECT_NEAR(result.rate * seconds, 6.0 * static_cast<double>(result.particles), 1e-6);
                EXPECT_DOUBLE_EQ(result.pairs_per_second_per_thread(), result.rate * result.neighbours);
                EXPECT_EQ(result.rates, std::vector{result.rate});
                EXPECT_GT(result.work.operations, 0);
                Roof const roof{1, result.work.operations, result.work.operations, 1e300};
                EXPECT_DOUBLE_EQ(result.share_of(roof), result.rate);
            }
    set_threads(0);
}

TEST(Benchmark, ListsNeighboursAnewOnTheWay) {
    EXPECT_GE(run_benchmark({.dimension = 2, .gradient = "sph", .particles = 1e3, .steps = 12}).listings, 2);
}

TEST(Benchmark, RepeatedReportsTheMedianAndTheBest) {
    auto const result = run_benchmark({.gradient = "sph", .particles = 1e3, .steps = 1, .repeat = 4});
    auto rates = result.rates;
    ASSERT_EQ(rates.size(), 4u);
    std::sort(rates.begin(), rates.end());
    EXPECT_EQ(result.rate, rates[1]);
    EXPECT_EQ(result.best_rate(), rates[3]);
}

}  // namespace

}  // namespace coronet
