// SPDX-License-Identifier: BSD-3-Clause

// A column of liquid: how it is laid, what theory says of it, and what its probe sees.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "coronet/cases/column_mode.hpp"
#include "coronet/cases/column_probe.hpp"
#include "coronet/cases/fill.hpp"
#include "coronet/cases/growth_fit.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

constexpr double R = 5, L = 45;

Case column(double amplitude, int waves = 1) {
    return read_case(
        fmt::format("name = 'column'\ndimension = 3\n[[shapes]]\nkind = 'column'\nradius = {}\nlength = {}\n"
                    "[column]\namplitude = {}\nwaves = {}\n[domain]\nperiodic = 'x'\nsize = [{}, 1, 1]\n"
                    "[particles]\nspacing = 1\nlattice = 'shells'\n[fluid]\ndensity = 2\nviscosity = 0.3\n"
                    "surface_tension = 10\nsound_speed = 30\n[method]\nkernel = 'wendland-c2'\n"
                    "support = 2.8\n[surface]\ncoverage_radius = 1.4\n[time]\nend = 1\n",
                    R, L, amplitude, waves, L),
        "column");
}

Particles<3> particles_of(Case const& c) {
    auto state = initial_state(c, fill<3>(c), WallSeeds<3>{});
    return std::move(state.particles);
}

std::map<std::string, Measure> by_name(std::vector<Measure> const& measures) {
    std::map<std::string, Measure> named;
    for (Measure const& m : measures) named.emplace(m.name, m);
    return named;
}

}  // namespace

TEST(ColumnMode, MeetsTheStressesAtTheSurface) {
    // u_r = I_1(kr) + B I_1(lr), u_z = i (I_0(kr) + B l/k I_0(lr)), p = -s/k I_0(kr), with R = rho = sigma = 1.
    auto const I = [](int n, double z) { return std::cyl_bessel_i(n, z); };
    auto const slope = [&](double z) { return I(0, z) - I(1, z) / z; };
    for (double const k : {0.2, 0.698, 0.95})
        for (double const nu : {0.01, 0.1, 1.0, 10.0}) {
            double const s = column_growth_rate(k, 1, 1, 1, nu), l = std::sqrt(k * k + s / nu);
            double const B = -2 * k * k * I(1, k) / ((k * k + l * l) * I(1, l));  // no tangential stress
            double const rise = (I(1, k) + B * I(1, l)) / s,
                         normal = -s / k * I(0, k) - 2 * nu * (k * slope(k) + B * l * slope(l)),
                         curvature = -(1 - k * k) * rise;
            EXPECT_NEAR(normal, curvature, 1e-9 * std::fabs(curvature)) << k << " " << nu;
        }
}

TEST(ColumnMode, TendsToRayleighsRatesOfNoAndOfAllViscosity) {
    for (double const k : {0.3, 0.7}) {
        double const I0 = std::cyl_bessel_i(0, k), I1 = std::cyl_bessel_i(1, k);
        // Of 2 m radius, and 5 kg/m^3 and 3 N/m.
        double const rate = std::sqrt(3.0 / (5 * 8)), unit = std::sqrt(5 * 3.0 * 2);
        EXPECT_NEAR(column_growth_rate(k / 2, 2, 5, 3, 0), std::sqrt(k * (1 - k * k) * I1 / I0) * rate, 1e-12);
        EXPECT_NEAR(column_growth_rate(k / 2, 2, 5, 3, 1e-7 * unit), column_growth_rate(k / 2, 2, 5, 3, 0), 1e-6);
        double const stokes = (1 - k * k) / (2 * (k * k * I0 * I0 / (I1 * I1) - 1 - k * k));
        EXPECT_NEAR(column_growth_rate(k / 2, 2, 5, 3, 1e4 * unit) / rate, stokes / 1e4, 1e-5 * stokes / 1e4);
    }
}

TEST(GrowthFit, FindsTheRateOfWhatStartedAtRestInNoise) {
    for (double const noise : {0.0, 1e-3}) {
        std::mt19937 engine(1);
        std::normal_distribution<double> scatter;
        std::vector<double> times, values;
        for (int k = 0; k < 60; ++k) {
            times.push_back(10 + 0.1 * k);
            values.push_back(0.02 * std::cosh(0.6 * (times.back() - 9)) + noise * scatter(engine));
        }
        auto const fit = fit_growth(times, values, 0.5);
        ASSERT_TRUE(fit.has_value());
        EXPECT_NEAR(fit->rate, 0.6, noise == 0 ? 1e-7 : 3 * fit->rate_error);
        EXPECT_LT(fit->rate_error, 0.01);
        EXPECT_FALSE(fit_growth({times.begin(), times.begin() + 5}, {values.begin(), values.begin() + 5}, 0.5));
        EXPECT_FALSE(fit_growth(times, values, 0.1)) << "is beyond three times what was expected";
    }
}

TEST(ColumnShells, HoldTheVolumeEvenlyWithItsWave) {
    auto const c = column(0.1, 3);
    auto const seeds = fill<3>(c);
    EXPECT_NEAR(static_cast<double>(seeds.size()) * seeds.volume, pi * R * R * L, 1e-9 * pi * R * R * L);
    double least = 1e9;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        auto const& x = seeds.position[i];
        EXPECT_LE(std::hypot(x[1], x[2]), R * (1 + 0.1 * std::cos(2 * pi * 3 * x[0] / L)) - 0.2) << i;
        for (std::size_t j = 0; j < i; ++j) {
            auto way = x - seeds.position[j];
            way[0] -= L * std::round(way[0] / L);
            least = std::min(least, norm2(way));
        }
    }
    EXPECT_GT(std::sqrt(least), 0.5);
}

TEST(ColumnProbe, SeesTheWaveAndNoOtherAndTheNeck) {
    for (int const n : {1, 2, 3}) {
        auto const c = column(0.02, n);
        for (int const m : {1, 2, 3}) {
            ProbeKeys keys;
            keys.waves = m;
            auto const row = ColumnProbe(keys, c).sample({0, particles_of(c), c});
            EXPECT_NEAR(row[0], m == n ? 0.02 : 0, 0.001) << n << " " << m;
            EXPECT_NEAR(row[1], 0.98, 0.03);
        }
    }
}

TEST(Column, CutFromALatticeHoldsItsAxis) {
    auto const c = read_case(
        "name = 'column'\ndimension = 3\n[[shapes]]\nkind = 'column'\nradius = 0.35\nlength = 1.9\n"
        "[domain]\nperiodic = 'x'\nsize = [1.9, 2, 2]\n[particles]\nspacing = 0.1\n[fluid]\ndensity = 1\n"
        "sound_speed = 1\n[time]\nend = 1\n",
        "column");
    std::size_t across = 0;  // of a row of the lattice
    for (int y = -3; y <= 3; ++y)
        for (int z = -3; z <= 3; ++z) across += y * y + z * z <= 12;
    EXPECT_EQ(fill<3>(c).size(), 19 * across);
}

TEST(ColumnProbe, SaysThatShortWavesAreStable) {
    auto const c = column(0.01, 8);  // k R = 5.6
    ProbeKeys keys;
    keys.waves = 8;
    ColumnProbe probe(keys, c);
    probe.sample({0, particles_of(c), c});
    auto const growth = by_name(probe.measures()).at("growth_rate");
    EXPECT_TRUE(std::isnan(growth.value));
    EXPECT_FALSE(growth.reference.has_value());
    EXPECT_NE(growth.source.find("stable; k R = 5.585"), std::string::npos) << growth.source;
}

TEST(ColumnProbe, FindsTheGrowthRateAndWhenItBreaks) {
    auto const c = column(0.01);
    ProbeKeys keys;
    ColumnProbe probe(keys, c);
    double const exact = column_growth_rate(2 * pi / L, R, 2, 10, 0.3), rate = 1.2 * exact;
    for (int k = 0; k <= 24; ++k) {
        auto const now = column(0.01 * std::cosh(rate * 0.12 * k / exact));
        probe.sample({0.12 * k / exact, particles_of(now), c});
    }
    EXPECT_TRUE(std::isnan(by_name(probe.measures()).at("breaks_at").value));
    auto broken = particles_of(c);
    for (std::size_t i = 0; i < broken.size(); ++i) {
        auto x = broken.view().get<Position>(i);
        x[0] *= 0.8;
        broken.view().set<Position>(i, x);
    }
    probe.sample({100, broken, c});
    auto const measures = by_name(probe.measures());
    EXPECT_NEAR(*measures.at("growth_rate").reference, exact, 1e-12 * exact);
    EXPECT_NEAR(*measures.at("growth_rate").error, 0.2, 0.02);
    EXPECT_EQ(measures.at("breaks_at").value, 100);
}

}  // namespace coronet
