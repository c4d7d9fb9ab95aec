// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/walls.hpp"

#include <gtest/gtest.h>

namespace coronet {

// A plate of two spacings: two rows of wall particles, one for each side, and liquid before one of them.
TEST(Walls, HoldOffWhatStandsInFrontOfThemOnly) {
    double const dx = 0.1, least = dx / 2;
    Particles<2> particles(1, 6);
    particles.allocate(Fields<Position, ToMirror>{});
    auto const view = particles.view();
    view.set<Position>(0, {{1.6 * dx, 0}});
    for (int row = 0; row < 2; ++row)
        for (int k = 0; k < 3; ++k) {
            std::size_t const w = 1 + static_cast<std::size_t>(3 * row + k);
            double const side = row == 0 ? 1 : -1;
            view.set<Position>(w, {{0.5 * side * dx, (k - 1) * dx}});
            view.set<ToMirror>(w, {{side * dx, 0}});
        }
    for (std::size_t m = particles.begin(Role::mirror); m < particles.size(); ++m)
        view.set<Position>(m, view.get<Position>(m - 6) + view.get<ToMirror>(m - 6));
    Neighbours<2> neighbours(3 * dx, 0.1 * dx);
    neighbours.update(particles);
    Walls<2> walls({});
    walls.follow(particles, neighbours);

    auto const held = [&](Vector<double, 2> const& d) { return walls.held_off(particles, neighbours, 0, d, least); };
    Vector<double, 2> const away{{0.3 * dx, 0.2 * dx}};
    EXPECT_EQ(held(away)[0], away[0]);
    EXPECT_EQ(held(away)[1], away[1]);
    // The surface is at dx, so 0.1 dx is free.
    EXPECT_NEAR(held({{-0.3 * dx, 0.2 * dx}})[0], -0.1 * dx, 1e-15);
    EXPECT_EQ(held({{-0.3 * dx, 0.2 * dx}})[1], 0.2 * dx);
}

}  // namespace coronet
