// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_probe.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>

#include "coronet/cases/drop_outline.hpp"
#include "coronet/cases/mode_probe.hpp"
#include "coronet/cases/oscillation_fit.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/cases/static_drop_probe.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

constexpr double R = 20, spacing = 1;

Case drop_case(std::vector<std::string> const& more = {}) {
    return read_case(R"(name = "drop"
dimension = 2
[[shapes]]
kind = "disc"
radius = 20.0
[particles]
spacing = 1.0
[fluid]
density = 2.0
viscosity = 0.2
surface_tension = 10.0
sound_speed = 100.0
[time]
end = 1.0
)",
                     "drop.toml", more);
}

/// A drop of shells of particles, a spacing apart, displaced by the potential flow of mode n.
Particles<2> drop(double a, int n, double turn = 0, Vector<double, 2> const& centre = {},
                  Vector<double, 2> const& velocity = {}) {
    std::vector<Vector<double, 2>> points;
    for (double r = R - spacing / 2; r > 0.4; r -= spacing) {
        int const count = static_cast<int>(std::lround(2 * pi * r));
        for (int k = 0; k < count; ++k) {
            double const angle = 2 * pi * (k + 0.3) / count;
            auto const z = std::polar(r, angle);
            auto const moved = z + a * R * std::conj(std::polar(std::pow(r / R, n - 1), (n - 1) * angle - n * turn));
            points.push_back({{moved.real() + centre[0], moved.imag() + centre[1]}});
        }
    }
    Particles<2> particles(points.size());
    particles.allocate(Fields<Position, Velocity, Density, Mass>{});
    auto const view = particles.view();
    for (std::size_t i = 0; i < points.size(); ++i) {
        view.set<Position>(i, points[i]);
        view.set<Velocity>(i, velocity);
        view.set<Density>(i, 2.0);
        view.set<Mass>(i, 2.0 * pi * R * R / static_cast<double>(points.size()));
    }
    return particles;
}

std::map<std::string, Measure> by_name(std::vector<Measure> const& measures) {
    std::map<std::string, Measure> named;
    for (Measure const& m : measures) named.emplace(m.name, m);
    return named;
}

TEST(ModeOf, IsTheAmplitudeAndThePhaseOfAWave) {
    for (int const n : {2, 3, 4, 7}) {
        Polygon line;
        int const corners = 200;
        for (int k = 0; k < corners; ++k) {
            double const angle = 2 * pi * (k + 0.3 * std::sin(k)) / corners;  // uneven
            double const r = 3 + 0.2 * std::cos(n * (angle - 0.4));
            line.push_back({{r * std::cos(angle), r * std::sin(angle)}});
        }
        double const step = n * 2 * pi / corners;
        auto const found = mode_of(line, n);
        EXPECT_NEAR(std::abs(found), 0.2, 0.2 * step * step / 6) << n;
        EXPECT_NEAR(std::remainder(std::arg(found) + 0.4 * n, 2 * pi), 0, step * step / 6) << n;
        EXPECT_NEAR(std::abs(mode_of(line, n + 1)), 0, 0.2 * step * step) << n;
    }
}

TEST(ModeOf, ACircleIsNothingHoweverItsCornersLie) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> step(0.01, 0.1);
    Polygon line;
    for (double angle = 0; angle < 2 * pi; angle += step(engine))
        line.push_back({{2 * std::cos(angle), 2 * std::sin(angle)}});
    for (int const n : {2, 3, 4}) EXPECT_NEAR(std::abs(mode_of(line, n)), 0, 1e-15);
}

TEST(OscillationFit, FindsWhatIsInNoise) {
    for (double const noise : {0.0, 1e-4, 1e-2}) {
        int within = 0, runs = 20;
        for (int run = 0; run < runs; ++run) {
            std::mt19937 engine(static_cast<unsigned>(run));
            std::normal_distribution<double> scatter(0, 1);
            std::vector<double> times, values;
            for (int k = 0; k < 400; ++k) {
                times.push_back(3 + 0.02 * k);
                double const t = times.back() - 3;
                values.push_back(0.1 * std::exp(-0.3 * t) * std::cos(6.5 * t + 0.7) + 0.01 + noise * scatter(engine));
            }
            auto const fit = fit_oscillation(times, values, 5 + 0.3 * run);  // expected 20 % below to 65 % above
            ASSERT_TRUE(fit.has_value());
            if (noise == 0) {
                EXPECT_NEAR(fit->angular_frequency, 6.5, 1e-9);
                EXPECT_NEAR(fit->damping, 0.3, 1e-9);
                EXPECT_NEAR(fit->amplitude, 0.1, 1e-10);
                EXPECT_NEAR(std::remainder(fit->phase - 0.7, 2 * pi), 0, 1e-9);
                EXPECT_NEAR(fit->offset, 0.01, 1e-10);
                ++within;
            } else {
                within += std::fabs(fit->angular_frequency - 6.5) < 2 * fit->angular_frequency_error &&
                          std::fabs(fit->damping - 0.3) < 2 * fit->damping_error;
                // Of w and of b alike, sqrt(2) noise/amplitude over the root of the integral of t^2 exp(-2 b t).
                EXPECT_NEAR(fit->damping_error, fit->angular_frequency_error, 0.2 * fit->damping_error);
            }
        }
        EXPECT_GE(within, 15) << noise;  // of 20, of which 91 % are expected
    }
}

TEST(OscillationFit, OfTooFewSamplesOrNoNumbersIsNothing) {
    std::vector<double> times, values;
    for (int k = 0; k < 100; ++k) {
        times.push_back(0.1 * k);
        values.push_back(std::cos(times.back()));
    }
    EXPECT_TRUE(fit_oscillation(times, values, 1));
    EXPECT_FALSE(fit_oscillation({times.begin(), times.begin() + 10}, {values.begin(), values.begin() + 10}, 1));
    values[50] = NAN;
    EXPECT_FALSE(fit_oscillation(times, values, 1));
}

TEST(Snapshot, FindsTheOutlineOnceForAllProbes) {
    auto const c = drop_case();
    auto const particles = drop(0.1, 3);
    Snapshot<2> const now(0, particles, c);
    auto const& outline = now.outline();
    EXPECT_EQ(outline.area, drop_outline(particles, c).area);
    double const before = outline.area;
    particles.view().set<Position>(0,
                                   {{2 * R, 0}});  // moves what is looked at: another outline, if it were found again
    EXPECT_EQ(now.outline().area, before);
    EXPECT_NE(drop_outline(particles, c).area, before);
}

TEST(DropProbe, SeesADropAsItIs) {
    auto const c = drop_case();
    DropProbe<2> probe(c);
    auto const row = probe.sample({0, drop(0, 2), c});
    EXPECT_NEAR(row[0], 1, 0.01);
    EXPECT_NEAR(row[1], R, 2e-3 * R);
    EXPECT_NEAR(row[2], pi * R * R, 2e-3 * pi * R * R);
    EXPECT_EQ(row[3], std::lround(2 * pi * (R - 0.5)));
    EXPECT_EQ(row[4], 0);
    EXPECT_NEAR(row[5], 1, 0.03);

    DropProbe<2> oval(c);
    auto const stretched = oval.sample({0, drop(0.1, 2), c});
    EXPECT_NEAR(stretched[0], 1.1 / 0.9, 0.02);
    EXPECT_NEAR(by_name(oval.measures()).at("circularity_final").value, stretched[0], 0);
}

TEST(DropProbe, MeasuresDriftFromTheLineOfTheFirstMomentum) {
    auto const c = drop_case();
    Vector<double, 2> const v{{3, -1}};
    DropProbe<2> straight(c), bent(c);
    double const capillary = std::sqrt(10 / (2 * R));
    for (int k = 0; k <= 4; ++k) {
        double const t = 0.5 * k;
        straight.sample({t, drop(0, 2, 0, t * v, v), c});
        Vector<double, 2> const aside{{0, k == 2 ? 0.01 * R : 0}}, faster{{k == 3 ? 0.02 * capillary : 0, 0}};
        bent.sample({t, drop(0, 2, 0, t * v + aside, v + faster), c});
    }
    auto const right = by_name(straight.measures()), wrong = by_name(bent.measures());
    EXPECT_LT(right.at("centre_drift").value, 1e-13);
    EXPECT_LT(right.at("momentum_drift").value, 1e-12);
    EXPECT_NEAR(wrong.at("centre_drift").value, 0.01, 1e-12);
    EXPECT_NEAR(wrong.at("momentum_drift").value, 0.02, 1e-12);
    EXPECT_TRUE(right.at("centre_drift").reference.has_value());

    auto const falling = drop_case({"fluid.gravity=[0, -9.81]"});
    DropProbe<2> pulled(falling);
    pulled.sample({0, drop(0, 2), falling});
    EXPECT_FALSE(by_name(pulled.measures()).at("centre_drift").reference.has_value());
}

TEST(DropProbe, TellsTheLastAndTheLargestErrorOfTheArea) {
    auto const c = drop_case();
    DropProbe<2> probe(c);
    double const first = probe.sample({0, drop(0, 2), c})[2];
    double const worst = probe.sample({1, drop(0.3, 2), c})[2];  // the flow of mode 2 that far takes a^2 of the area
    double const last = probe.sample({2, drop(0.1, 2), c})[2];
    ASSERT_GT(std::fabs(worst - first), 0.05 * first);
    auto const measures = by_name(probe.measures());
    EXPECT_NEAR(measures.at("area_error").value, last / (pi * R * R) - 1, 1e-13);
    EXPECT_NEAR(measures.at("area_error_max").value, std::fabs(worst / (pi * R * R) - 1), 1e-13);
}

TEST(ModeProbe, FindsPeriodAndDampingOfADropWhateverItsAxis) {
    auto const c = drop_case();
    auto const exact = drop_mode(2, 3, R, 2, 10, 0.2);
    ASSERT_TRUE(exact.has_value());
    double const w = 0.96 * exact->angular_frequency, b = 1.3 * exact->damping;
    for (double const turn : {0.0, 0.5}) {
        ProbeKeys keys;
        keys.mode = 3;
        ModeProbe<2> probe(keys, c);
        std::vector<double> first;
        for (int k = 0; k <= 240; ++k) {
            double const t = k * 6 * 2 * pi / (240 * w);
            auto const row = probe.sample({t, drop(0.04 * std::exp(-b * t) * std::cos(w * t), 3, turn), c});
            if (k == 0) first = row;
            EXPECT_NEAR(row[1], 0, 4e-4);
        }
        // The outermost shell is half a spacing inside, where the flow goes as r^2: the boundary outside of it sees all.
        EXPECT_NEAR(first[0], 0.04, 0.04 * 0.01);
        auto const measures = by_name(probe.measures());
        auto const &period = measures.at("period"), &damping = measures.at("damping_rate");
        EXPECT_NEAR(*period.reference, 2 * pi / exact->angular_frequency, 1e-12 * period.value);
        EXPECT_NEAR(*damping.reference, exact->damping, 1e-12 * exact->damping);
        EXPECT_NEAR(*period.error, 1 / 0.96 - 1, 1e-3);
        EXPECT_NEAR(*damping.error, 0.3, 0.03);
        EXPECT_GT(*period.standard_error, 0);
        EXPECT_LT(*period.standard_error, 1e-3 * period.value);
    }
}

TEST(ModeProbe, SaysWhyThereIsNoMeasure) {
    ProbeKeys const keys;
    auto const c = drop_case(), thick = drop_case({"fluid.viscosity=30"});
    ModeProbe<2> brief(keys, c), stiff(keys, thick);
    EXPECT_TRUE(brief.measures().empty());
    for (auto* probe : {&brief, &stiff}) probe->sample({0, drop(0.04, 2), c});
    for (auto const* probe : {&brief, &stiff}) {
        auto const period = by_name(probe->measures()).at("period");
        EXPECT_TRUE(std::isnan(period.value));
        EXPECT_TRUE(period.source.starts_with("not fitted")) << period.source;
    }
    EXPECT_NE(by_name(stiff.measures()).at("period").source.find("does not oscillate"), std::string::npos);
}

/// A drop in 3D, as a case lays it.
Case drop_in_3d(double amplitude, int mode, std::vector<std::string> more = {}) {
    more.push_back(fmt::format("drop.amplitude={}", amplitude));
    more.push_back(fmt::format("drop.mode={}", mode));
    return read_case(R"(name = "drop"
dimension = 3
[[shapes]]
kind = "drop"
radius = 6.0
[particles]
spacing = 0.75
lattice = "shells"
[fluid]
density = 2.0
viscosity = 0.2
surface_tension = 10.0
sound_speed = 100.0
[time]
end = 1.0
)",
                     "drop.toml", more);
}

Particles<3> particles_of(Case const& c) {
    auto const seeds = fill<3>(c);
    auto state = initial_state(c, seeds, WallSeeds<3>{});
    return std::move(state.particles);
}

TEST(ModeProbe, InThreeDimensionsSeesTheWaveAndNoOther) {
    for (int const n : {2, 3, 4}) {
        auto const c = drop_in_3d(0.02, n, {"shapes.0.rotation=30"});
        for (int const m : {2, 3, 4}) {
            ProbeKeys keys;
            keys.mode = m;
            auto const row = ModeProbe<3>(keys, c).sample({0, particles_of(c), c});
            ASSERT_EQ(row.size(), 1u);
            // Sums over particles on the outer shells: 1500 of them resolve it to a few percent.
            EXPECT_NEAR(row[0], m == n ? 0.02 : 0, 0.002) << n << " " << m;
        }
    }
}

TEST(ModeProbe, InThreeDimensionsFindsPeriodAndDamping) {
    auto const exact = drop_mode(3, 2, 6, 2, 10, 0.2);
    ASSERT_TRUE(exact.has_value());
    double const w = 1.05 * exact->angular_frequency, b = 0.8 * exact->damping;
    auto const c = drop_in_3d(0.02, 2);
    ModeProbe<3> probe({}, c);
    for (int k = 0; k <= 120; ++k) {
        double const t = k * 5 * 2 * pi / (120 * w);
        auto const now = drop_in_3d(0.02 * std::exp(-b * t) * std::cos(w * t), 2);
        probe.sample({t, particles_of(now), c});
    }
    auto const measures = by_name(probe.measures());
    EXPECT_NEAR(*measures.at("period").error, 1 / 1.05 - 1, 2e-3);
    EXPECT_NEAR(*measures.at("damping_rate").error, -0.2, 0.02);
}

TEST(DropProbe, InThreeDimensionsSeesADropAsItIs) {
    auto const round = drop_in_3d(0, 2), oval = drop_in_3d(0.1, 2);
    auto const seen = DropProbe<3>(round).sample({0, particles_of(round), round});
    EXPECT_NEAR(seen[0], 1, 0.02);
    EXPECT_NEAR(seen[1], 6, 0.06);
    EXPECT_NEAR(seen[2], 4 * pi / 3 * 6 * 6 * 6, 0.02 * 4 * pi / 3 * 6 * 6 * 6);
    EXPECT_EQ(seen[4], 0);  // voids
    EXPECT_NEAR(DropProbe<3>(oval).sample({0, particles_of(oval), oval})[0], 1.1 / 0.95, 0.03);
}

TEST(StaticDropProbe, KnowsLaplacesPressureAndTheFastest) {
    auto const c = drop_in_3d(0, 2, {"initial.pressure=3.5"});
    auto particles = particles_of(c);
    particles.allocate(Fields<Pressure>{});
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto const x = particles.view().get<Position>(i);
        particles.view().set<Pressure>(i, norm2(x) < 9 ? 3.5 : 100);
        particles.view().set<Velocity>(i, {{7, 0, 0}});
    }
    StaticDropProbe<3> probe(c);
    particles.view().set<Velocity>(0, {{7, 50, 0}});
    probe.sample({0, particles, c});  // of the first half
    particles.view().set<Velocity>(0, {{7, 0.3, 0}});
    probe.sample({1, particles, c});
    auto const measures = by_name(probe.measures());
    EXPECT_NEAR(measures.at("laplace_pressure").value, 3.5, 1e-9);
    EXPECT_NEAR(*measures.at("laplace_pressure").reference, 2 * 10 / 6.0, 1e-3);
    EXPECT_NEAR(measures.at("spurious_capillary_number").value, 0.2 * 0.3 / 10, 1e-4);
}

}  // namespace

}  // namespace coronet
