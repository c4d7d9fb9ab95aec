// SPDX-License-Identifier: BSD-3-Clause

// What holds of flow by projection as a whole: it keeps momentum and angular momentum, takes energy only, leaves no
// divergence where it is exact, and moves a stretching drop as theory has it.

#include <gtest/gtest.h>

#include "coronet/cases/probe.hpp"
#include "coronet/core/error.hpp"
#include "coronet/core/parallel.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

/// An ellipse off the centre, jittered, in a smooth flow with divergence; `method` is further keys of that section.
Case flow(std::string const& method, double viscosity) {
    return read_case(fmt::format("name = 'flow'\ndimension = 2\n"
                                 "[[shapes]]\nkind = 'ellipse'\ncentre = [2, -1]\nsemi_axes = [1, 0.6]\n"
                                 "[particles]\nspacing = 0.1\njitter = 0.1\nrotation = 17\n"
                                 "[initial]\nvelocity = ['sin(2*y) - x*y + 1', 'cos(3*x) + 0.5*x']\n"
                                 "[fluid]\ndensity = 2\nviscosity = {}\n"
                                 "[method]\nscheme = 'projection'\nkernel = 'wendland-c2'\nsupport = 3\n{}\n"
                                 "[time]\nend = 1\n",
                                 viscosity, method),
                     "flow");
}

double reading(Scheme<2> const& scheme, std::string const& name) {
    for (Reading const& reading : scheme.readings())
        if (reading.name == name) return reading.value;
    ADD_FAILURE() << name;
    return NAN;
}

std::unique_ptr<Scheme<2>> after_steps(Case const& c, int steps, double step) {
    auto scheme = make_scheme<2>(c);
    for (int k = 0; k < steps; ++k) {
        scheme->begin_step(k * step);
        scheme->advance(k * step, step);
    }
    return scheme;
}

}  // namespace

TEST(ProjectionScheme, KeepsMomentumAndAngularMomentumToRoundOff) {
    for (std::string const method : {"compact_share = 0", "compact_share = 0.1", "pressure_operator = 'thesis'"}) {
        Case const c = flow(method, 0.05);
        auto const before = totals(make_scheme<2>(c)->particles());
        auto const scheme = after_steps(c, 20, 2e-3);
        auto const after = totals(scheme->particles());
        // Rounding grows with the steps; the first step takes the divergence out with pressures of order 1/step.
        for (int k = 0; k < 2; ++k)
            EXPECT_NEAR(after.momentum[k], before.momentum[k], 1e-13 * before.momentum_scale) << method;
        if (scheme->counters().singular_matrices == 0) {
            EXPECT_NEAR(after.angular_momentum[2], before.angular_momentum[2], 1e-12 * before.momentum_scale) << method;
        }
    }
}

TEST(ProjectionScheme, OnlyTakesEnergy) {
    for (double const viscosity : {0.0, 0.05})
        for (std::string const share : {"0", "0.1", "0.5"}) {
            auto scheme = make_scheme<2>(flow("compact_share = " + share, viscosity));
            double energy = totals(scheme->particles()).kinetic_energy;
            for (int k = 0; k < 20; ++k) {
                scheme->begin_step(k * 2e-3);
                scheme->advance(k * 2e-3, 2e-3);
                double const now = totals(scheme->particles()).kinetic_energy;
                EXPECT_LE(now, energy * (1 + 1e-12)) << share << " " << viscosity << " step " << k;
                energy = now;
            }
        }
}

TEST(ProjectionScheme, LeavesNoDivergenceWhereItIsExact) {
    auto const left = [](std::string const& method) {
        return reading(*after_steps(flow(method, 0), 1, 2e-3), "divergence_max");
    };
    // The divergence of the flow is of order 1/s.
    EXPECT_LT(left("compact_share = 0\ntolerance = 1e-8\npreconditioner = 'jacobi'"), 1e-6);
    EXPECT_GT(left("compact_share = 0.1\ntolerance = 1e-8"), 1e-4);
}

TEST(ProjectionScheme, SaysHowFarASolveCameThatDidNotConverge) {
    try {
        after_steps(flow("tolerance = 1e-8\nmost_iterations = 3", 0), 1, 2e-3);
        FAIL() << "three iterations cannot be enough";
    } catch (RunError const& error) {
        EXPECT_NE(std::string(error.what()).find("after 3 iterations the residual is"), std::string::npos);
    }
}

TEST(ProjectionScheme, GivesTheSameBitsForAnyNumberOfThreads) {
    auto const run = [](int count) {
        set_threads(count);
        auto const scheme = after_steps(flow("", 0.05), 5, 2e-3);
        set_threads(0);
        std::vector<double> all;
        for (std::size_t i = 0; i < scheme->particles().owned(); ++i)
            for (int k = 0; k < 2; ++k) all.push_back(scheme->particles().view().at<Velocity>(k)[i]);
        return all;
    };
    EXPECT_EQ(run(1), run(2));
}

TEST(ProjectionScheme, ShowsTheStressThatActedInItsLastStep) {
    // A flow with constant gradient has the same viscous stress everywhere, at the surface, too, and no force comes of
    // it but at the surface. In so short a step nothing changes, so pressures of any size do no harm.
    auto const flow_of = [](std::string const& fluid, std::string const& method) {
        return read_case(
            "name = 'strain'\ndimension = 2\n[[shapes]]\nkind = 'disc'\nradius = 1\n"
            "[particles]\nspacing = 0.1\njitter = 0.1\n[initial]\nvelocity = ['3*x - y', '2*x - 3*y']\n"
            "[fluid]\ndensity = 2\n" +
                fluid +
                "\n[method]\nscheme = 'projection'\n"
                "kernel = 'wendland-c2'\nsupport = 3\n" +
                method + "\n[time]\nend = 1\n",
            "strain");
    };
    double const mu = 0.5;
    for (auto const& [viscosity, step] : {std::pair{0.0, "explicit"}, {mu, "explicit"}, {mu, "implicit"}}) {
        auto const scheme = after_steps(
            flow_of(fmt::format("viscosity = {}", viscosity), fmt::format("viscous_step = '{}'", step)), 1, 1e-10);
        auto const view = scheme->particles().view();
        double pressed = 0;
        for (std::size_t i = 0; i < scheme->particles().owned(); ++i) {
            auto const sigma = view.get<Stress>(i);
            double const p = view.get<Pressure>(i), few = 1e-12 * (std::fabs(p) + 1);
            EXPECT_NEAR(sigma(0, 0), -p + 6 * viscosity, 1e-7 * viscosity + few) << step;
            EXPECT_NEAR(sigma(1, 1), -p - 6 * viscosity, 1e-7 * viscosity + few) << step;
            EXPECT_NEAR(sigma(0, 1), viscosity, 1e-7 * viscosity + few) << step;
            pressed = std::max(pressed, std::fabs(p));
        }
        EXPECT_GT(pressed, 0.1) << "nothing is seen of the pressure";
    }
}

TEST(ProjectionScheme, KeepsParticlesApartWhereTheyAreShifted) {
    auto const least = [](std::string const& shifting) {
        return after_steps(flow("shifting = '" + shifting + "'", 0.05), 40, 4e-3)->arrangement().smallest_distance;
    };
    EXPECT_GT(least("xu"), 1.1 * least("none"));
}

/// A drop of unit radius in the flow (-x, y), Fang et al. (2009) section 4.1, by projection: its axes follow theory.
TEST(ProjectionScheme, StretchesADropAsTheoryHasIt) {
    Case c = read_case(
        "name = 'stretching'\ndimension = 2\n[[shapes]]\nkind = 'disc'\nradius = 1\n"
        "[particles]\nspacing = 0.08\n[initial]\nvelocity = ['-100*x', '100*y']\n"
        "[fluid]\ndensity = 1000\n[method]\nscheme = 'projection'\nkernel = 'w6'\nsupport = 3.5\n"
        "pressure_kernel = 'w3'\ncompact_share = 0\ntolerance = 1e-2\npreconditioner = 'jacobi'\n"
        "[time]\nend = 5e-3\n[[probes]]\nkind = 'stretching'\nrates = ['-100', '100']\n",
        "stretching");
    auto const scheme = make_scheme<2>(c);
    auto const probes = make_probes<2>(c);
    probes[0]->sample({0, scheme->particles(), c});
    constexpr int steps = 50;
    for (int k = 0; k < steps; ++k) {
        scheme->begin_step(k * 1e-4);
        scheme->advance(k * 1e-4, 1e-4);
    }
    probes[0]->sample({5e-3, scheme->particles(), c});
    EXPECT_LT(probes[0]->measures()[0].value, 0.02);
}

}  // namespace coronet
