// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/check_state.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace coronet {

namespace {

Particles<3> three_at_rest() {
    Particles<3> particles(3);
    particles.allocate<Position, Velocity, Acceleration, Density>();
    for (std::size_t i = 0; i < 3; ++i) {
        particles.view().set<Position>(i, {{static_cast<double>(i), 0.5, -2}});
        particles.view().set<Density>(i, 1000.0);
    }
    return particles;
}

std::string complaint(Particles<3> const& particles) {
    try {
        check_state(particles);
        return "";
    } catch (RunError const& error) {
        return error.what();
    }
}

}  // namespace

TEST(CheckState, LetsALiquidAtRestPass) { EXPECT_EQ(complaint(three_at_rest()), ""); }

TEST(CheckState, NamesTheFirstParticleThatCannotBe) {
    double const infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
    auto const with = [](auto const& change) {
        auto particles = three_at_rest();
        change(particles.view(), std::size_t{1});
        change(particles.view(), std::size_t{2});
        return complaint(particles);
    };
    std::string const where = "the flow has blown up: particle 1 at (1, 0.5, -2) m has ";
    EXPECT_EQ(with([&](auto view, std::size_t i) {
                  view.template set<Velocity>(i, {{0, infinite, 0}});
              }),
              where + "density 1000 kg/m^3, speed inf m/s and acceleration 0 m/s^2");
    EXPECT_EQ(with([&](auto view, std::size_t i) {
                  view.template set<Acceleration>(i, {{none, 0, 0}});
              }),
              where + "density 1000 kg/m^3, speed 0 m/s and acceleration nan m/s^2");
    for (double const density : {0.0, -1.0, infinite, none})
        EXPECT_TRUE(with([&](auto view, std::size_t i) { view.template set<Density>(i, density); }).starts_with(where));
}

}  // namespace coronet
