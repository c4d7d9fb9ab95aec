// SPDX-License-Identifier: BSD-3-Clause

// The tables of lid-driven cavities: which there are, and that they are of a lid that drags the liquid along.

#include <gtest/gtest.h>

#include <algorithm>

#include "coronet/cases/cavity_probe.hpp"

namespace coronet {

TEST(Cavity, HasATableForEachOfItsReynoldsNumbers) {
    for (int const dimension : {2, 3})
        for (double const reynolds : {100, 400, 1000}) {
            auto const profiles = cavity_reference(dimension, reynolds);
            ASSERT_EQ(profiles.size(), 2);
            for (Profile const& profile : profiles) {
                ASSERT_GE(profile.position.size(), 13) << profile.name << " in " << dimension << "D at " << reynolds;
                EXPECT_EQ(profile.position.size(), profile.reference.size());
                for (double const x : profile.position) EXPECT_TRUE(x > 0 && x < 1) << "walls say nothing";
            }
            auto const largest = std::max_element(profiles[0].reference.begin(), profiles[0].reference.end());
            auto const where = profiles[0].position[static_cast<std::size_t>(largest - profiles[0].reference.begin())];
            EXPECT_GT(where, 0.9) << "u is largest below the lid, at " << dimension << "D, " << reynolds;
            EXPECT_LT(*std::min_element(profiles[1].reference.begin(), profiles[1].reference.end()), -0.2)
                << "v is down at the wall that the lid moves towards";
        }
}

TEST(Cavity, AtReynolds1000In3DIsThatOfAlbensoederAndKuhlmann) {
    EXPECT_EQ(cavity_table(3, 1000), "cavity3d_albensoeder_kuhlmann2005");
    auto const u = cavity_reference(3, 1000)[0];
    auto const at = std::find(u.position.begin(), u.position.end(), 0.1016);
    ASSERT_NE(at, u.position.end());
    EXPECT_EQ(u.reference[static_cast<std::size_t>(at - u.position.begin())], -0.27293) << "their Table 5";
}

TEST(Cavity, HasNoTableElsewhere) { EXPECT_TRUE(cavity_reference(2, 500)[0].position.empty()); }

}  // namespace coronet
