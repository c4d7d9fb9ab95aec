// SPDX-License-Identifier: BSD-3-Clause

// Drops whose tension acts on their boundary, in both schemes.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

/// An ellipse of 10 spacings in its mean radius of 1, rho = sigma = 1, off the origin and drifting; jittered particles.
Case drop(std::string const& scheme, std::string const& shifting) {
    bool const projects = scheme == "projection";
    return read_case(
        fmt::format("name = 'drop'\ndimension = 2\n[[shapes]]\nkind = 'drop'\nradius = 1\ncentre = [3, -2]\n"
                    "[drop]\namplitude = 0.1\n[particles]\nspacing = 0.1\njitter = 0.1\n"
                    "[initial]\nvelocity = ['0.3', '0.2']\n[fluid]\ndensity = 1\nsurface_tension = 1\n"
                    "viscosity = 0.05\n{}[method]\nscheme = '{}'\nshifting = '{}'\nsupport = 3.5\n"
                    "[time]\nend = 1\n",
                    projects ? "" : "sound_speed = 15\n", scheme, shifting),
        "drop");
}

struct Watched {
    Totals<2> first, last;
    double first_energy, last_energy, pressure;
};

Watched watch(Case const& c, int steps, double step) {
    auto const scheme = make_scheme<2>(c);
    auto const energy = [&] {
        double surface = 0;
        for (auto const& reading : scheme->readings())
            if (reading.name == "surface_energy") surface = reading.value;
        return surface + totals(scheme->particles()).kinetic_energy;
    };
    scheme->begin_step(0);
    Watched seen{totals(scheme->particles()), {}, energy(), 0, 0};
    for (int k = 0; k < steps; ++k) {
        scheme->begin_step(k * step);
        scheme->advance(k * step, step);
    }
    scheme->refresh();
    seen.last = totals(scheme->particles());
    seen.last_energy = energy();
    auto const view = scheme->particles().view();
    std::size_t const n = scheme->particles().owned();
    seen.pressure = sum_over(n, 0.0, [&](std::size_t i) { return view.at<Pressure>()[i]; }) / static_cast<double>(n);
    return seen;
}

}  // namespace

TEST(DropOnBoundary, KeepsMomentumItsMomentAndTheLineOfItsCentre) {
    for (auto const& [scheme, shifting, steps, step] : {std::tuple{"projection", "none", 50, 2e-3},
                                                        {"projection", "conserving", 50, 2e-3},
                                                        {"weakly-compressible", "conserving", 150, 5e-4}}) {
        auto const seen = watch(drop(scheme, shifting), steps, step);
        double const mass = seen.first.mass, time = steps * step;
        auto const line = seen.first.centre() + time / mass * seen.first.momentum;
        EXPECT_LT(std::sqrt(norm2(seen.last.momentum - seen.first.momentum)), 1e-12 * mass) << scheme << shifting;
        EXPECT_LT(std::sqrt(norm2(seen.last.centre() - line)), 1e-12) << scheme << shifting;
        EXPECT_NEAR(seen.last.angular_momentum[2], seen.first.angular_momentum[2], 1e-11 * mass) << scheme << shifting;
    }
}

TEST(DropOnBoundary, LosesEnergyAndHasThePressureOfLaplace) {
    auto const seen = watch(drop("projection", "conserving"), 400, 2e-3);
    EXPECT_LT(seen.last_energy, seen.first_energy);
    // Half a period later it is as wide across: the mean pressure is that of a disc, and what moves adds less than the
    // square of the amplitude.
    EXPECT_NEAR(seen.pressure, 1, 0.06);
}

}  // namespace coronet
