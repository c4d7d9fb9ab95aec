// SPDX-License-Identifier: BSD-3-Clause

// Liquid that joins and breaks: two drops that collide, and a column that goes on across a period.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/column_mode.hpp"
#include "coronet/cases/column_probe.hpp"
#include "coronet/cases/pieces_probe.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

/// The rows of a probe from start to end, at every hundredth, and its measures.
template <int D, class P>
struct Seen {
    std::vector<std::vector<double>> rows;
    std::map<std::string, double> measures;

    Seen(Case const& c, P& probe) {
        auto const scheme = make_scheme<D>(c);
        int samples = 0;
        for (double time = 0;;) {
            scheme->begin_step(time);
            bool const last = time >= c.time.end;
            if (last || time >= samples * c.time.end / 100) {
                scheme->refresh();
                scheme->arrangement();
                rows.push_back(probe.sample({time, scheme->particles(), c, scheme->readings()}));
                ++samples;
            }
            if (last) break;
            double const step = std::min(scheme->time_limit().step, c.time.end - time);
            scheme->advance(time, step);
            time += step;
        }
        for (Measure const& m : probe.measures()) measures[m.name] = m.value;
    }
};

template <int D>
void join() {
    // Two drops of 6 spacings in a radius that graze.
    auto const c =
        load_case(D == 2 ? "drop-collision" : "drop-collision-3d",
                  {"particles.spacing=1.6666667e-4", "parameters.impact=0.3", "time.end=0.0015", "method.support=2.8"});
    PiecesProbe<D> probe(c);
    Seen<D, PiecesProbe<D>> const seen(c, probe);
    EXPECT_EQ(seen.rows.front()[0], 2);
    EXPECT_EQ(seen.rows.back()[0], 1);
    // Balls of 1.4 spacings touch where particles are 2.8 apart, surfaces 1.8.
    EXPECT_NEAR(seen.measures.at("joining_gap"), 1.8, 0.1);
    EXPECT_LT(seen.measures.at("momentum_drift"), 1e-12);
    EXPECT_LT(seen.measures.at("angular_momentum_drift"), 1e-12);
}

}  // namespace

TEST(CollidingDrops, JoinAndKeepMomentumAndItsMoment) {
    join<2>();
    join<3>();
}

TEST(LiquidColumn, GrowsAsTheoryHasItAndKeepsMomentumAndEnergy) {
    for (std::string const shifting : {"none", "conserving"}) {
        auto const c =
            load_case("liquid-column", {"particles.spacing=2.5e-4", "time.end=0.006", "method.shifting=" + shifting});
        ColumnProbe probe({}, c);
        Seen<3, ColumnProbe> const seen(c, probe);
        double const found = std::log(seen.rows.back()[0] / seen.rows.front()[0]) / c.time.end,
                     exact = column_growth_rate(2 * std::numbers::pi / 9e-3, 1e-3, 1000, 0.07, 0.0264575);
        EXPECT_NEAR(found / exact, 1, 0.05) << shifting;
        EXPECT_LT(seen.measures.at("momentum_drift"), 1e-12) << shifting;
        EXPECT_LT(seen.measures.at("energy_drift"), 2e-3) << shifting;
    }
}

TEST(LiquidColumn, KeepsItsMomentAboutTheAxisAndGoesOnAcrossThePeriod) {
    // It turns and drifts along its axis, so that every particle crosses the period.
    auto const c = load_case("liquid-column", {"particles.spacing=2.5e-4", "time.end=0.0015", "particles.jitter=0.1",
                                               "initial.velocity=['6', '0.3-40*z', '40*y']", "fluid.sound_speed=8"});
    auto const scheme = make_scheme<3>(c);
    auto const before = totals(scheme->particles());
    double const first_area = [&] {
        scheme->begin_step(0);
        return scheme->readings()[1].value;
    }();
    double time = 0;
    while (time < c.time.end) {
        scheme->begin_step(time);
        double const step = std::min(scheme->time_limit().step, c.time.end - time);
        scheme->advance(time, step);
        time += step;
    }
    scheme->begin_step(time);
    auto const after = totals(scheme->particles());
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(after.momentum[k], before.momentum[k], 1e-12 * before.momentum_scale);
    double const radius = 1e-3;
    // About the axis, which drifts along y.
    auto const moment = [](Totals<3> const& t) {
        auto const x = t.centre();
        return t.angular_momentum[0] - x[1] * t.momentum[2] + x[2] * t.momentum[1];
    };
    EXPECT_NEAR(moment(after), moment(before), 1e-12 * radius * before.momentum_scale);
    EXPECT_GT(std::fabs(moment(before)), 1e-3 * radius * before.momentum_scale);
    EXPECT_NEAR(scheme->readings()[1].value, first_area, 0.03 * first_area);
}

}  // namespace coronet
