// SPDX-License-Identifier: BSD-3-Clause

// Where the energy of a drop goes: what tension gives, the flow and compression have, and viscosity takes.

#include "coronet/cases/energy_ledger.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"

namespace coronet {

namespace {

/// A wave of mode 2 on a drop, at rest; rho = sigma = R = 1.
Case drop(int dimension, std::string const& scheme, double viscosity, std::string const& more = "") {
    bool const projects = scheme == "projection", flat = dimension == 2;
    return read_case(
        fmt::format("name = 'drop'\ndimension = {}\n[[shapes]]\nkind = 'drop'\nradius = 1\n[drop]\namplitude = 0.1\n"
                    "[particles]\nspacing = {}\nlattice = 'shells'\n[initial]\npressure = '{}'\n[fluid]\n"
                    "density = 1\nsurface_tension = 1\nviscosity = {}\n{}[method]\nscheme = '{}'\nsupport = {}\n"
                    "kernel = 'wendland-c2'\ncompact_share = 0\n{}\n[surface]\ncoverage_radius = 1.4\n[time]\n"
                    "end = 1\n",
                    dimension, flat ? 0.1 : 0.16666667, projects ? "0" : (flat ? "1" : "2"), viscosity,
                    projects ? "" : "sound_speed = 15\n", scheme, flat ? 3.5 : 2.8, more),
        "drop");
}

struct Run {
    std::map<std::string, double> measures, last;
};

/// A quarter of a period, in which half of the energy of the wave becomes that of the flow.
template <int D>
Run run(Case const& c, double step) {
    auto const scheme = make_scheme<D>(c);
    EnergyLedger<D> ledger(c);
    Run run;
    auto const look = [&](double time) {
        scheme->refresh();
        scheme->arrangement();
        std::vector<double> row;
        ledger.sample({time, scheme->particles(), c, scheme->readings()}, row);
    };
    double const end = D == 2 ? 0.6 : 0.5;
    double time = 0;
    for (int k = 0; time < end; ++k, time += step) {
        scheme->begin_step(time);
        if (k % 20 == 0) look(time);
        scheme->advance(time, step);
    }
    scheme->begin_step(time);
    look(time);
    std::vector<Measure> measures;
    ledger.add_measures(measures);
    for (Measure const& m : measures) run.measures[m.name] = m.value;
    for (Reading const& r : scheme->readings()) run.last[r.name] = r.value;
    return run;
}

}  // namespace

TEST(EnergyOfADrop, IsExchangedWithoutLossWhereNothingIsViscous) {
    auto const flat = run<2>(drop(2, "weakly-compressible", 0), 1e-3);
    auto const ball = run<3>(drop(3, "weakly-compressible", 0), 2e-3);
    for (auto const* seen : {&flat, &ball}) {
        EXPECT_LT(seen->measures.at("tension_work_error"), 1e-3);
        EXPECT_LT(seen->measures.at("energy_drift"), 2e-3);
        EXPECT_GT(seen->last.at("tension_work"), 0.01);  // of a surface energy of 2 pi and 4 pi
        EXPECT_LT(std::fabs(seen->last.at("dissipated_energy")), 1e-15);
    }
}

TEST(EnergyOfADrop, ByProjectionIsLostToFirstOrderInTheStep) {
    auto const c = drop(2, "projection", 0);
    auto const coarse = run<2>(c, 2e-3), fine = run<2>(c, 1e-3);
    EXPECT_LT(coarse.measures.at("energy_drift"), 0.01);
    EXPECT_NEAR(fine.measures.at("energy_drift") / coarse.measures.at("energy_drift"), 0.5, 0.1);
    EXPECT_LT(coarse.measures.at("tension_work_error"), 1e-5);
    EXPECT_LT(run<3>(drop(3, "projection", 0), 4e-3).measures.at("energy_drift"), 0.02);
}

TEST(EnergyOfADrop, LosesWhatViscosityTakes) {
    auto const stress = run<2>(drop(2, "weakly-compressible", 0.05), 1e-3);
    auto const both = run<3>(drop(3, "weakly-compressible", 0.05, "central_share = 0.2"), 2e-3);
    EXPECT_LT(stress.measures.at("energy_drift"), 2e-3);
    EXPECT_LT(both.measures.at("energy_drift"), 2e-3);
    EXPECT_GT(both.last.at("dissipated_energy"), 0.1 * both.last.at("tension_work"));
    // Whatever the scheme, and however the viscous step is made.
    double const taken = stress.last.at("dissipated_energy");
    EXPECT_GT(taken, 0.1 * stress.last.at("tension_work"));
    for (std::string const step : {"explicit", "implicit"}) {
        auto const projected = run<2>(drop(2, "projection", 0.05, "viscous_step = '" + step + "'"), 2e-3);
        EXPECT_LT(projected.measures.at("energy_drift"), 0.01) << step;
        EXPECT_NEAR(projected.last.at("dissipated_energy"), taken, 0.01 * taken) << step;
    }
}

}  // namespace coronet
