// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/terms/wall_contact.hpp"

#include <gtest/gtest.h>

#include "tests/terms/random_pair.hpp"

namespace coronet {

TEST(WallContact, PushesLiquidOffWallParticlesThatAreTooNear) {
    int near = 0;
    for (auto const& ij : random_pairs<2, WallContact>(2000)) {
        double const r = std::sqrt(ij.r2);
        WallContact const contact{.range = 0.5, .sound_speed = 3};
        auto const push = contact(ij).dv;
        if (r >= 0.5) {
            EXPECT_EQ(norm2(push), 0);
            continue;
        }
        ++near;
        EXPECT_NEAR(std::sqrt(norm2(push)), 9 / 0.5 * (1 - r / 0.5), 1e-7 * 18);
        EXPECT_GT(dot(push, ij.x), 0);
        auto liquid = ij;
        liquid.j.to_mirror = {};
        EXPECT_EQ(norm2(contact(liquid).dv), 0);
    }
    EXPECT_GT(near, 20);
}

}  // namespace coronet
