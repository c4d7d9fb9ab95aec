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

/// The same in 3D, of 6 spacings, with a spin.
Case drop_in_3d(std::string const& scheme, std::string const& shifting, std::string const& more = {}) {
    bool const projects = scheme == "projection";
    return read_case(
        fmt::format(
            "name = 'drop'\ndimension = 3\n[[shapes]]\nkind = 'drop'\nradius = 1\ncentre = [3, -2, 1]\n"
            "[drop]\namplitude = 0.1\n[particles]\nspacing = 0.16666667\njitter = 0.1\n"
            "[initial]\nvelocity = ['0.3 - y - 2', '0.2 + x - 3', '0.1']\n[fluid]\ndensity = 1\n"
            "surface_tension = 1\nviscosity = 0.05\n{}[method]\nscheme = '{}'\nshifting = '{}'\nsupport = 2.8\n"
            "kernel = 'wendland-c2'\ncentral_share = 0.2\n[surface]\ncoverage_radius = 1.4\n{}[time]\nend = 1\n",
            projects ? "" : "sound_speed = 15\n", scheme, shifting, more),
        "drop");
}

template <int D>
struct Watched {
    Totals<D> first, last;
    double first_energy, last_energy, pressure;
};

template <int D = 2>
Watched<D> watch(Case const& c, int steps, double step) {
    auto const scheme = make_scheme<D>(c);
    auto const energy = [&] {
        scheme->arrangement();
        double surface = 0;
        for (auto const& reading : scheme->readings())
            if (reading.name == "surface_energy") surface = reading.value;
        return surface + totals(scheme->particles()).kinetic_energy;
    };
    scheme->begin_step(0);
    Watched<D> seen{totals(scheme->particles()), {}, energy(), 0, 0};
    for (int k = 0; k < steps; ++k) {
        scheme->begin_step(k * step);
        scheme->advance(k * step, step);
    }
    scheme->refresh();
    seen.last = totals(scheme->particles());
    seen.last_energy = energy();
    auto const view = scheme->particles().view();
    std::size_t const n = scheme->particles().owned();
    seen.pressure =
        sum_over(n, 0.0, [&](std::size_t i) { return view.template at<Pressure>()[i]; }) / static_cast<double>(n);
    return seen;
}

Case symplectic(Case c) {
    c.time.stepping = "symplectic-euler";
    return c;
}

template <int D>
void expect_conservation(Case const& c, int steps, double step) {
    auto const seen = watch<D>(c, steps, step);
    double const mass = seen.first.mass, time = steps * step;
    auto const line = seen.first.centre() + time / mass * seen.first.momentum;
    std::string const which = fmt::format("{} {} {}", c.method.scheme, c.method.shifting, c.time.stepping);
    EXPECT_LT(std::sqrt(norm2(seen.last.momentum - seen.first.momentum)), 1e-12 * mass) << which;
    EXPECT_LT(std::sqrt(norm2(seen.last.centre() - line)), 1e-12) << which;
    EXPECT_LT(std::sqrt(norm2(seen.last.angular_momentum - seen.first.angular_momentum)), 1e-11 * mass) << which;
}

}  // namespace

TEST(DropOnBoundary, KeepsMomentumItsMomentAndTheLineOfItsCentre) {
    expect_conservation<2>(drop("projection", "none"), 50, 2e-3);
    expect_conservation<2>(drop("projection", "conserving"), 50, 2e-3);
    expect_conservation<2>(drop("weakly-compressible", "conserving"), 150, 5e-4);
    expect_conservation<2>(symplectic(drop("weakly-compressible", "conserving")), 150, 1e-3);
}

TEST(DropOnBoundary, InThreeDimensionsKeepsMomentumItsMomentAndTheLineOfItsCentre) {
    expect_conservation<3>(drop_in_3d("projection", "conserving"), 20, 4e-3);
    expect_conservation<3>(drop_in_3d("weakly-compressible", "none"), 60, 1e-3);
    expect_conservation<3>(drop_in_3d("weakly-compressible", "conserving"), 60, 1e-3);
    expect_conservation<3>(symplectic(drop_in_3d("weakly-compressible", "conserving")), 60, 2e-3);
}

TEST(DropOnBoundary, InThreeDimensionsTheThesissTensionDoesNot) {
    auto const seen = watch<3>(drop_in_3d("weakly-compressible", "none", "tension_force = 'curvature'\n"), 60, 1e-3);
    EXPECT_GT(std::sqrt(norm2(seen.last.momentum - seen.first.momentum)), 1e-6 * seen.first.mass);
}

TEST(Threads, ADropIn3DHasTheSameBitsForAnyNumberOfThreads) {
    for (std::string const stepping : {"predictor-corrector", "symplectic-euler"}) {
        auto c = drop_in_3d("weakly-compressible", "conserving");
        c.time.stepping = stepping;
        std::vector<Totals<3>> totals;
        for (int const threads : {1, 3}) {
            set_threads(threads);
            totals.push_back(watch<3>(c, 10, 1e-3).last);
        }
        set_threads(0);
        EXPECT_EQ(totals[0].kinetic_energy, totals[1].kinetic_energy) << stepping;
        for (int k = 0; k < 3; ++k) EXPECT_EQ(totals[0].mass_moment[k], totals[1].mass_moment[k]) << stepping;
    }
}

TEST(DropOnBoundary, LosesEnergyAndHasThePressureOfLaplace) {
    auto const seen = watch(drop("projection", "conserving"), 400, 2e-3);
    EXPECT_LT(seen.last_energy, seen.first_energy);
    // Half a period later it is as wide across: the mean pressure is that of a disc, and what moves adds less than the
    // square of the amplitude.
    EXPECT_NEAR(seen.pressure, 1, 0.06);
}

TEST(DropOnBoundary, HasTheVolumeOfItsParticlesInSymplecticSteps) {
    auto c = symplectic(drop("weakly-compressible", "none"));
    c.particles.lattice = "shells";  // from which no particle joins the surface
    c.particles.jitter = 0;
    auto const scheme = make_scheme<2>(c);
    auto const excess = [&] {  // of the content of the boundary
        scheme->refresh();
        scheme->arrangement();
        double content = 0;
        for (auto const& reading : scheme->readings())
            if (reading.name == "surface_content") content = reading.value;
        return content / totals(scheme->particles()).volume - 1;
    };
    scheme->begin_step(0);
    double const first = excess(), step = 2e-3;
    double late = 0;  // the mean over the last sixth of two periods: the density follows the content by a step
    int samples = 0;
    for (int k = 0; k < 2600; ++k) {
        scheme->advance(k * step, step);
        scheme->begin_step((k + 1) * step);
        if (k < 2600 * 5 / 6 || k % 5 != 0) continue;
        late += excess();
        ++samples;
    }
    EXPECT_NEAR(late / samples, first, 3e-5);
}

TEST(DropOnBoundary, GoesItsWayBesideAnotherInSymplecticSteps) {
    // Two that pass each other, far enough for neither to feel the other: particles are sorted anew, and what a step
    // leaves to the next has to stay with its drop.
    auto const energies = [](std::string const& shapes, std::string const& velocity) {
        auto const c = read_case(
            fmt::format("name = 'drops'\ndimension = 2\n{}[particles]\nspacing = 0.2\n[initial]\n"
                        "velocity = ['0', '{}']\n[fluid]\ndensity = 1\nsurface_tension = 1\nviscosity = 0.05\n"
                        "sound_speed = 15\n[method]\nsupport = 2.8\nkernel = 'wendland-c2'\n[surface]\n"
                        "coverage_radius = 1.4\n[time]\nend = 1\nstepping = 'symplectic-euler'\n",
                        shapes, velocity),
            "drops");
        auto const scheme = make_scheme<2>(c);
        for (int k = 0; k < 300; ++k) {
            scheme->begin_step(k * 2e-3);
            scheme->advance(k * 2e-3, 2e-3);
        }
        return totals(scheme->particles()).kinetic_energy;
    };
    std::string const one = "[[shapes]]\nkind = 'ellipse'\ncentre = [0, 0]\nsemi_axes = [1.2, 0.9]\n",
                      other = "[[shapes]]\nkind = 'ellipse'\ncentre = [6, 0.61]\nsemi_axes = [0.9, 1.3]\n";
    EXPECT_NEAR(energies(one + other, "x > 3 ? -2 : 0") / (energies(one, "0") + energies(other, "-2")), 1, 1e-9);
}

TEST(DropOnBoundary, BreathesInSymplecticStepsAsInOthers) {
    // Of the kinetic energy of the first period, what is left in the sixth.
    auto const left = [](std::string const& stepping, double courant) {
        auto const c = read_case(
            fmt::format("name = 'drop'\ndimension = 2\n[[shapes]]\nkind = 'drop'\nradius = 1\n[drop]\namplitude = 0\n"
                        "[particles]\nspacing = 0.1\nlattice = 'shells'\n[initial]\nvelocity = ['0.1*x', '0.1*y']\n"
                        "[fluid]\ndensity = 1\nsurface_tension = 0.01\nviscosity = 0\nsound_speed = 15\n"
                        "[method]\nsupport = 2.8\nkernel = 'wendland-c2'\n[surface]\ncoverage_radius = 1.4\n"
                        "[time]\nend = 1\nstepping = '{}'\n",
                        stepping),
            "drop");
        auto const scheme = make_scheme<2>(c);
        double const step = courant * 2.8 / 3 * 0.1 / 15, period = 2 * std::numbers::pi / (2.405 * 15);  // of J_0(k r)
        double first = 0, last = 0;
        for (int k = 0; k * step < 6 * period; ++k) {
            scheme->begin_step(k * step);
            double const energy = totals(scheme->particles()).kinetic_energy;
            if (k * step < period) first = std::max(first, energy);
            if (k * step > 5 * period) last = std::max(last, energy);
            scheme->advance(k * step, step);
        }
        return last / first;
    };
    EXPECT_NEAR(left("symplectic-euler", 0.6), left("predictor-corrector", 0.25), 0.02);
}

}  // namespace coronet
