// SPDX-License-Identifier: BSD-3-Clause

// The rotating square patch at its start, where everything about it is known.

#include <fstream>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/probe.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"

namespace coronet {

namespace {

std::string text_of(std::string const& file) {
    std::ifstream stream(CORONET_SOURCE "/cases/" + file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

Case patch(std::vector<std::string> const& settings = {}) {
    return read_case(text_of("square-patch-shifting.toml"), "square-patch-shifting.toml", settings);
}

}  // namespace

TEST(SquarePatchShifting, StartsFromThePressureOfTheIncompressiblePatch) {
    Case const c = patch();
    Formula pressure(c.initial.pressure, c.parameters);
    std::stringstream table(text_of("reference/square_patch_initial_pressure.csv"));
    double const scale = c.fluid.density * std::pow(c.parameters.at("omega"), 2);
    // What the series leaves out from m = 17 on, 8/pi^3 sum 1/m^3 over odd m, all of one sign at a side.
    double left_out = 0;
    for (int m = 17; m < 2000; m += 2) left_out += 8 / std::pow(std::numbers::pi * m, 3);
    int points = 0;
    for (std::string line; std::getline(table, line);) {
        double x, y, p;
        if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &x, &y, &p) != 3) continue;
        EXPECT_NEAR(pressure(Vector<double, 2>{{x, y}}, 0) / scale, p, left_out + 1e-8) << x << ", " << y;
        ++points;
    }
    EXPECT_EQ(points, 121);
}

TEST(PatchProbe, SeesTheExactSquareWhereItLooksAtTheOutline) {
    for (std::string const shifting : {"none", "sun"}) {
        Case const c = patch({"particles.spacing=0.05", "method.shifting=" + shifting});
        auto const scheme = make_scheme<2>(c);
        scheme->begin_step(0);
        scheme->refresh();
        auto const probes = make_probes<2>(c);
        auto const seen = probes[0]->sample(Snapshot<2>(0, scheme->particles(), c));
        // Followed particles lie half a spacing inside; the outline is moved out by it.
        double const half = shifting == "none" ? 0.475 : 0.5;
        EXPECT_NEAR(seen[0], half * std::numbers::sqrt2, 1e-14) << shifting;
        EXPECT_NEAR(seen[1], shifting == "none" ? std::hypot(0.475, 0.025) : std::hypot(0.5, 0.025), 1e-14) << shifting;
        EXPECT_EQ(seen[3], 1);
        EXPECT_NEAR(seen[4], 1, shifting == "none" ? 1e-3 : 1e-13) << "volumes follow the pressure";
        EXPECT_NEAR(seen[5], 1 / std::numbers::sqrt2, 1e-15);
    }
}

}  // namespace coronet
