// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/roofline.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "coronet/core/parallel.hpp"
#include "coronet/run/benchmark.hpp"
#include "coronet/run/memory.hpp"
#include "coronet/run/other_load.hpp"

namespace coronet {

namespace {

TEST(Roofline, IsTheLongerOfArithmeticAndMemory) {
    Roof const roof{1, 10, 20, 100};
    EXPECT_DOUBLE_EQ(roof.least_seconds({50, 300}, "double"), 5);
    EXPECT_DOUBLE_EQ(roof.least_seconds({50, 300}, "mixed"), 3);
    EXPECT_FALSE(roof.memory_bound({50, 300}, "double"));
    EXPECT_TRUE(roof.memory_bound({50, 300}, "mixed"));
}

TEST(Roofline, IsMeasured) {
    Roof const roof = measure_roof(1, std::size_t{1} << 22);
    set_threads(0);
    EXPECT_EQ(roof.threads, 1);
    EXPECT_GT(roof.double_operations, 1e6);
    EXPECT_GT(roof.float_operations, 1e6);
    EXPECT_GT(roof.bytes, 1e6);
}

TEST(Roofline, TheMachineTellsItsCores) {
    auto const machine = this_machine();
    EXPECT_GE(machine.cores, 1);
    EXPECT_GE(machine.vector_bits, 64);
    EXPECT_FALSE(machine.processor.empty());
    EXPECT_GE(OtherLoad().cores(), 0);
}

/// Plain SPH in one sweep reads V, p, v, rho and c beside the position, and keeps the two rates; in double a record
/// has all that it reads.
TEST(Work, OfOneSweepIsThatOnPaper) {
    Case const c = benchmark_case({.dimension = 2, .gradient = "sph"});
    EXPECT_DOUBLE_EQ(work_per_evaluation<2>(c, 40, 0).bytes, 8 * (8 + 3) + 2 * 8 * 8 + 4 * 40);
    EXPECT_DOUBLE_EQ(work_per_evaluation<2>(c, 40, 0).operations, 2 * work_per_evaluation<2>(c, 20, 0).operations);
}

TEST(Work, OfTheCoupledMethodGrowsFromThatOfPlainGradientsToThatOfCorrectedOnes) {
    Case const coupled = benchmark_case({.dimension = 3, .gradient = "cph"});
    Case const corrected = benchmark_case({.dimension = 3, .gradient = "fpm"});
    auto const at = [&](double exterior) { return work_per_evaluation<3>(coupled, 70, exterior).operations; };
    EXPECT_LT(at(0), at(1));
    EXPECT_DOUBLE_EQ(at(0.5), 0.5 * (at(0) + at(1)));
    EXPECT_EQ(at(1), work_per_evaluation<3>(corrected, 70, 0).operations);
}

TEST(MemoryGrowth, SeesWhatHasBeenFreedSince) {
    constexpr std::size_t size = std::size_t{64} << 20;
    MemoryGrowth const growth;
    auto block = std::make_unique<char[]>(size);
    for (std::size_t k = 0; k < size; k += 4096) static_cast<char volatile&>(block[k]) = 1;
    EXPECT_GT(growth.bytes(), 0.9 * size);
    std::size_t const most = growth.bytes();
    EXPECT_LT(most, 4.0 * size);
}

}  // namespace

}  // namespace coronet
