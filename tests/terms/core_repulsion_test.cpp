// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/terms/core_repulsion.hpp"

#include <gtest/gtest.h>

#include "tests/terms/random_pair.hpp"

namespace coronet {

namespace {

CoreRepulsion cores() {
    CoreRepulsion term{.range_in_spacings = 0.8};
    term.scale(0.9, 0.05, 2);  // a = 0.72 of a support of 1
    return term;
}

}  // namespace

TEST(CoreRepulsion, IsEqualAndOppositeAlongThePair) {
    int pushed = 0;
    for (auto const& ij : random_pairs<2, CoreRepulsion>(1000)) {
        auto const ji = swapped(ij);
        auto const on_i = ij.i.m * cores()(ij).dv, on_j = ji.i.m * cores()(ji).dv;
        EXPECT_LT(norm2(on_i + on_j), 1e-30 * norm2(on_i) + 1e-300);
        EXPECT_NEAR(ij.x[0] * on_i[1] - ij.x[1] * on_i[0], 0, 1e-15 * std::sqrt(norm2(on_i)));
        EXPECT_GE(dot(on_i, ij.x), 0);
        pushed += norm2(on_i) > 0;
        EXPECT_EQ(norm2(on_i) > 0, ij.r2 < 0.72 * 0.72);
    }
    EXPECT_GT(pushed, 300);
}

TEST(CoreRepulsion, CostsTheSurfaceEnergyOfAParticleForACompleteOverlap) {
    // Its work from the range to contact: sigma a in 2D, sigma a^2 in 3D.
    auto ij = random_pairs<3, CoreRepulsion>(1).front();
    for (int const dimension : {2, 3}) {
        CoreRepulsion term{.range_in_spacings = 0.8};
        term.scale(0.9, 0.05, dimension);
        double work = 0;
        int const steps = 1000;
        for (int k = 0; k < steps; ++k) {
            double const r = (k + 0.5) / steps * term.range;
            ij.x = {{r, 0, 0}}, ij.r2 = r * r;
            work += ij.i.m * term(ij).dv[0] * term.range / steps;
        }
        EXPECT_NEAR(work, 0.05 * term.range * (dimension == 3 ? term.range : 1), 1e-5 * work);
    }
}

TEST(CoreRepulsion, DoesNothingWithoutARange) {
    CoreRepulsion term;
    term.scale(1, 1, 2);
    auto ij = random_pairs<2, CoreRepulsion>(1).front();
    EXPECT_TRUE(cores().active());
    EXPECT_FALSE(CoreRepulsion{}.active());
    ij.x = {{0, 0}}, ij.r2 = 0;  // and particles in one place are no error
    EXPECT_EQ(norm2(cores()(ij).dv), 0);
}

}  // namespace coronet
