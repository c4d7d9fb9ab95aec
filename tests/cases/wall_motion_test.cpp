// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_motion.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace coronet {

TEST(WallMotion, HasTheDerivativesOfItsFormulas) {
    Case c;
    c.particles.spacing = 0.01;
    c.method.support = 3;
    c.fluid.sound_speed = 10;
    c.parameters = {{"w", 5}};
    Wall wall;
    wall.displacement = {"0.2*sin(w*t)", "0.1*t^2"};
    wall.turn = "30*(1 - cos(w*t))";
    WallMotion<2> motion(wall, c);
    for (double const t : {0.01, 0.4, 1.7}) {
        auto const pose = motion.at(t);
        double const s = std::sin(5 * t), k = std::cos(5 * t), degree = std::numbers::pi / 180;
        EXPECT_NEAR(pose.displacement[0], 0.2 * s, 1e-15);
        EXPECT_NEAR(pose.velocity[0], k, 1e-5);
        EXPECT_NEAR(pose.velocity[1], 0.2 * t, 1e-10);
        EXPECT_NEAR(pose.acceleration[0], -5 * s, 1e-5 * 5);
        EXPECT_NEAR(pose.acceleration[1], 0.2, 1e-7);
        EXPECT_NEAR(pose.turn, 30 * degree * (1 - k), 1e-15);
        EXPECT_NEAR(pose.spin, 150 * degree * s, 1e-5 * 3);
        EXPECT_NEAR(pose.spin_rate, 750 * degree * k, 1e-5 * 13);
    }
}

}  // namespace coronet
