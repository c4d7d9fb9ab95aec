// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/channel_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coronet/io/csv.hpp"

namespace coronet {

namespace {

using Model = Rheology::Model;

Rheology newtonian(double viscosity) { return {.model = Model::newtonian, .viscosity = viscosity}; }

}  // namespace

TEST(ChannelFlow, IsAParabolaAndALineOfANewtonianLiquid) {
    ChannelFlow const flow(newtonian(2), 3, 4, {.gap = 2, .lower = -1, .upper = 5});
    // 3 4/(2 2) (1 - y^2) + 2 + 3 y; the quadrature is of second order in a 4000th of the gap.
    for (double const y : {-1.0, -0.3, 0.0, 0.8, 1.0}) EXPECT_NEAR(flow.steady(y), 3 * (1 - y * y) + 2 + 3 * y, 1e-6);
}

TEST(ChannelFlow, HasAPlugWhereTheStressIsBelowTheYieldStress) {
    Rheology law{.model = Model::bingham, .yield_stress = 0.3, .plastic_viscosity = 1};
    ChannelFlow const flow(law, 1, 1, {.gap = 2, .lower = 0, .upper = 0});
    auto const exact = [](double y) {
        double const beyond = std::max(std::fabs(y) - 0.3, 0.0);
        return 0.5 * (0.7 * 0.7 - beyond * beyond);
    };
    for (double const y : {-1.0, -0.5, -0.2, 0.0, 0.31, 0.9}) EXPECT_NEAR(flow.steady(y), exact(y), 1e-6);
}

TEST(ChannelFlow, IsThatOfTheTabulatedProfiles) {
    // Half a gap, drive and consistency 1 (cases/reference/poiseuille_nonnewtonian.csv, by Gauss quadrature).
    Rheology const carreau{.model = Model::carreau_yasuda,
                           .power_index = 0.5,
                           .zero_shear_viscosity = 1,
                           .infinite_shear_viscosity = 0.1,
                           .time_constant = 1,
                           .yasuda_exponent = 2};
    ChannelFlow const flow(carreau, 1, 1, {.gap = 2, .lower = 0, .upper = 0});
    EXPECT_NEAR(flow.steady(0), 0.55683949, 2e-7);
}

TEST(ChannelFlow, StartsAtRestAndEndsSteady) {
    ChannelFlow const flow(newtonian(1e-3), 1000, 1e-4, {.gap = 1e-3, .lower = 0, .upper = 1.25e-5});
    for (double const y : {-4e-4, 0.0, 3e-4}) {
        EXPECT_NEAR(flow.from_rest(y, 1e-5), 0, 1e-9 * 1.25e-5 + 1e-4 * 1e-5);  // what the force does in that time
        EXPECT_NEAR(flow.from_rest(y, 3), flow.steady(y), 1e-11);
    }
}

}  // namespace coronet
