// SPDX-License-Identifier: BSD-3-Clause

// Two drops collide off-centre and tear apart: particles lose most of their neighbours, the small matrices of the
// corrected gradients become nearly singular, and the run must neither blow up nor lose momentum.

#include <gtest/gtest.h>

#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

struct Collision {
    double energy_before, energy_after, momentum_drift;
    std::int64_t singular;
};

Collision collide(std::string const& gradient, std::string const& jitter) {
    Case const c = read_case(
        "name = 'collide'\ndimension = 2\n[[shapes]]\nkind = 'disc'\nradius = 1e-3\ncentre = [-1.1e-3, 0]\n"
        "[[shapes]]\nkind = 'disc'\nradius = 1e-3\ncentre = [1.1e-3, 0.3e-3]\n"
        "[particles]\nspacing = 1e-4\nlattice = 'hexagonal'\njitter = " +
            jitter +
            "\n[initial]\nvelocity = ['x < 0 ? 1 : -1', '0']\n[fluid]\ndensity = 1000\nviscosity = 1e-3\n"
            "sound_speed = 20\n[method]\nartificial_viscosity = 0.05\ngradient = '" +
            gradient + "'\n[time]\nend = 2e-3\n",
        "collide");
    auto const scheme = make_scheme<2>(c);
    auto const before = totals(scheme->particles());
    for (double time = 0; time < c.time.end;) {
        scheme->begin_step(time);
        double const step = scheme->time_limit().step;
        scheme->advance(time, step);
        time += step;
    }
    auto const after = totals(scheme->particles());
    double drift = 0;
    for (int k = 0; k < 2; ++k)
        drift = std::max(drift, std::fabs(after.momentum[k] - before.momentum[k]) / before.momentum_scale);
    return {before.kinetic_energy, after.kinetic_energy, drift, scheme->counters().singular_matrices};
}

}  // namespace

TEST(CollidingDrops, StayStableWithEveryGradient) {
    for (std::string const gradient : {"sph", "cph", "fpm"})
        for (std::string const jitter : {"0", "0.1"}) {
            Collision const c = collide(gradient, jitter);
            EXPECT_LT(c.energy_after, 0.95 * c.energy_before) << gradient;
            EXPECT_GT(c.energy_after, 0.4 * c.energy_before) << gradient;
            EXPECT_LT(c.momentum_drift, 1e-13) << gradient;
            if (gradient != "sph") {
                EXPECT_GT(c.singular, 0) << "the splash should have left particles alone";
            }
        }
}

}  // namespace coronet
