// SPDX-License-Identifier: BSD-3-Clause

// The drop is followed in its semi-axes a_k. Its volume and the energy of its linear velocity v_k =
// (a_k'/a_k) x_k never change: the mean of x_k^2 over an ellipsoid is a_k^2/(D + 2), so the energy is mass/(2
// (D + 2)) sum_k a_k'^2.
#include "coronet/cases/stretching_drop.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using coronet::StretchingDrop, coronet::Vector;

/// The rows of numbers of a table: lines that start with # are comments, the next names the columns.
std::vector<std::vector<double>> read_table(std::string const& name) {
    std::ifstream file(CORONET_SOURCE "/cases/reference/" + name);
    std::vector<std::vector<double>> rows;
    bool named = false;
    for (std::string line, cell; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (named) {
            std::istringstream cells(line);
            for (rows.emplace_back(); std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
        }
        named = true;
    }
    return rows;
}

TEST(StretchingDrop, InThePlaneIsTheReference) {
    auto const rows = read_table("elliptical_drop.csv");  // t, a, b, A, dA/dt, p_centre
    ASSERT_EQ(rows.size(), 126u);
    StretchingDrop<2> drop({{1, 1}}, {{-100, 100}}, 1000);
    for (auto const& row : rows) {
        ASSERT_EQ(row.size(), 6u);
        drop.advance_to(row[0]);
        // The axes are printed to 1e-12 m, the pressure to 1e-6 Pa.
        EXPECT_NEAR(drop.semi_axes()[0], row[1], 0.5e-12 + 1e-12) << row[0] << " s";
        EXPECT_NEAR(drop.semi_axes()[1], row[2], 0.5e-12 + 3e-12) << row[0] << " s";
        EXPECT_NEAR(drop.centre_pressure(), row[5], 0.5e-6 + 4e-12 * 5e6) << row[0] << " s";
    }
}

struct Start {
    Vector<double, 3> semi_axes, rates;
};

/// Spheroids that spread or stretch (rate B of either sign), and one with three axes.
std::vector<Start> starts() {
    return {{{{1, 1, 1}}, {{3, 3, -6}}},
            {{{1, 1, 1}}, {{-3, -3, 6}}},
            {{{2, 2, 0.5}}, {{-3, -3, 6}}},
            {{{1, 0.7, 1.4}}, {{2, 3, -5}}}};
}

constexpr double density = 1000;

double volume(Vector<double, 3> const& a) { return 4.18879020478639098 * a[0] * a[1] * a[2]; }

TEST(StretchingDrop, KeepsItsVolume) {
    for (auto const& [a, rates] : starts()) {
        StretchingDrop<3> drop(a, rates, density);
        for (double time = 0; time < 1; time += 0.05) {
            drop.advance_to(time);
            // Three axes, each to 1e-12 of its length.
            EXPECT_NEAR(drop.semi_axes()[0] * drop.semi_axes()[1] * drop.semi_axes()[2], a[0] * a[1] * a[2],
                        3e-12 * a[0] * a[1] * a[2])
                << time;
        }
    }
}

TEST(StretchingDrop, KeepsItsEnergy) {
    for (auto const& [a, rates] : starts()) {
        double const mass = density * volume(a);
        double energy = 0;
        for (int k = 0; k < 3; ++k) energy += mass / 10 * std::pow(rates[k] * a[k], 2);
        StretchingDrop<3> drop(a, rates, density);
        // a' by differences of eight points, (rate * step)^8 from exact. The rounding of the axes over these
        // few steps, 2e-15, grows by 2/(rate * step) = 700 for a' and twice that for the energy.
        double const step = 0.001;
        std::array<Vector<double, 3>, 9> at;
        for (double time = 5 * step; time < 1; time += 0.05) {
            for (int k = -4; k <= 4; ++k) {
                drop.advance_to(time + k * step);
                at[static_cast<std::size_t>(k + 4)] = drop.semi_axes();
            }
            auto const speed = (1 / (840 * step)) * (672.0 * (at[5] - at[3]) - 168.0 * (at[6] - at[2]) +
                                                     32.0 * (at[7] - at[1]) - 3.0 * (at[8] - at[0]));
            EXPECT_NEAR(mass / 10 * norm2(speed), energy, 1e-11 * energy) << time;
        }
    }
}

/// Spheroids have one rate B and so a closed form of their time: with a = a_0 = a_1, c = a_2 = a0^2 c0/a^2
/// and a' = B a, c' = -2 B c, energy says B^2 (2 a^2 + 4 c^2) = const. Hence t = integral of da/(a B), here
/// by Simpson's rule in log a.
double time_to_reach(double a_end, Vector<double, 3> const& start, double rate) {
    int const panels = 2000;
    double const width = std::log(a_end / start[0]) / panels;
    auto const inverse_rate = [&](double k) {
        double const stretch = std::exp(k * width), a = start[0] * stretch, c = start[2] / (stretch * stretch);
        return std::sqrt((2 * a * a + 4 * c * c) / (2 * start[0] * start[0] + 4 * start[2] * start[2])) / rate;
    };
    double time = 0;
    for (int k = 0; k < panels; ++k)
        time += width / 6 * (inverse_rate(k) + 4 * inverse_rate(k + 0.5) + inverse_rate(k + 1));
    return time;
}

TEST(StretchingDrop, OfRevolutionIsWhereItsEnergyTakesIt) {
    for (double const rate : {-3.0, 3.0})
        for (Vector<double, 3> const start : {Vector<double, 3>{{1, 1, 1}}, Vector<double, 3>{{2, 2, 0.5}}})
            for (double const stretch : {1.01, 1.2, 1.5, 2.0}) {
                double const a = rate > 0 ? start[0] * stretch : start[0] / stretch;
                StretchingDrop<3> drop(start, {{rate, rate, -2 * rate}}, density);
                drop.advance_to(time_to_reach(a, start, rate));
                // Simpson's error is w^4/2880 f < 1e-14: f is singular no nearer than pi/6, so f <
                // 4!/(pi/6)^4 f.
                EXPECT_NEAR(drop.semi_axes()[0], a, 4e-12 * a) << rate;
                EXPECT_EQ(drop.semi_axes()[0], drop.semi_axes()[1]) << rate;
                EXPECT_NEAR(drop.semi_axes()[2], start[2] * std::pow(start[0] / a, 2),
                            8e-12 * start[2] * stretch * stretch);
            }
}

TEST(StretchingDrop, StartsWithThePressureOfItsStretching) {
    // p_c = (rho/2) sum (a'/a)^2/sum a^-2: the circle of Monaghan (1994), 5 MPa, and a sphere, (1000/2) 54/3.
    EXPECT_EQ(StretchingDrop<2>({{1, 1}}, {{-100, 100}}, 1000).centre_pressure(), 5e6);
    EXPECT_EQ(StretchingDrop<3>({{1, 1, 1}}, {{3, 3, -6}}, 1000).centre_pressure(), 9e3);
}

TEST(StretchingDrop, IsDrivenByItsPressureAlone) {
    // Momentum on the axis: rho a_k'' = 2 p_c/a_k, a_k'' by differences of four points and the middle.
    for (auto const& [a, rates] : starts()) {
        StretchingDrop<3> drop(a, rates, density);
        double const step = 0.001;
        std::array<Vector<double, 3>, 5> at;
        double pressure = 0;
        for (int k = 0; k < 5; ++k) {
            drop.advance_to(0.1 + k * step);
            at[static_cast<std::size_t>(k)] = drop.semi_axes();
            if (k == 2) pressure = drop.centre_pressure();
        }
        auto const force = (1 / (12 * step * step)) * (16.0 * (at[1] + at[3]) - 30.0 * at[2] - at[0] - at[4]);
        // The differences leave (step * rate)^4 of it, at rates up to 10, times 6!/90 for the sixth
        // derivative.
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(density * force[k] * at[2][k], 2 * pressure, 8 * 1e-8 * 2 * pressure) << k;
    }
}

TEST(StretchingDrop, IsTheSameInOneAdvanceOrMany) {
    StretchingDrop<3> once({{1, 1, 1}}, {{3, 3, -6}}, density), often = once;
    once.advance_to(0.5);
    for (int k = 1; k <= 1000; ++k) often.advance_to(0.0005 * k);
    often.advance_to(0.2);  // in the past: nothing happens
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(often.semi_axes()[k], once.semi_axes()[k], 2e-12);
}

TEST(StretchingDrop, WithoutARateStaysAsItIs) {
    StretchingDrop<3> drop({{1, 0.7, 1.4}}, {}, density);
    drop.advance_to(10);
    EXPECT_EQ(norm2(drop.semi_axes() - Vector<double, 3>{{1, 0.7, 1.4}}), 0);
    EXPECT_EQ(drop.centre_pressure(), 0);
}

}  // namespace
