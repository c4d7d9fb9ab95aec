// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/measured_curve.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace coronet {

namespace {

/// 1 + t^2 from 0 to 2, in steps.
Curve parabola(double step, double late = 0) {
    Curve curve;
    for (int k = 0; k * step <= 2; ++k) {
        curve.time.push_back(k * step + late);
        curve.value.push_back(1 + std::pow(k * step, 2));
    }
    return curve;
}

}  // namespace

TEST(Curve, HasTheMeanOfItsTrapezia) {
    Curve const curve{{0, 1, 3}, {0, 2, 0}};
    EXPECT_EQ(curve.at(0.5), 1);
    EXPECT_EQ(curve.at(2), 1);
    EXPECT_NEAR(curve.mean(0.5, 2), (0.5 * 1.5 + 1 * 1.5) / 1.5, 1e-15);
    EXPECT_TRUE(std::isnan(curve.mean(0.5, 4)));
    EXPECT_EQ(curve.first_above(1), 1);
    EXPECT_TRUE(std::isnan(curve.first_above(2)));
}

TEST(Curve, ThatIsLateIsFoundToBe) {
    Curve const computed = parabola(1e-3);
    for (double const late : {-0.1, 0.0, 0.3}) {
        Curve const measured = parabola(0.25, late);
        EXPECT_NEAR(fitted_lateness(computed, measured, 1.8), late, 1e-3);
        EXPECT_NEAR(largest_difference(computed, measured, 1.8, late), 0, 1e-6);  // chords of the computed one
    }
    // As it stands the largest is at t = 1.05, where 1 + 0.75^2 was measured.
    EXPECT_NEAR(largest_difference(computed, parabola(0.25, 0.3), 1.8), (1 + 1.05 * 1.05) / 1.5625 - 1, 1e-6);
    EXPECT_TRUE(std::isnan(largest_difference(computed, parabola(0.25, 0.3), 2.1)));
    EXPECT_TRUE(std::isnan(fitted_lateness(Curve{}, parabola(0.25), 1.8)));
}

TEST(Curve, IsReadFromATable) {
    EXPECT_EQ(builtin_curve("dambreak_martin_moyce1952_a225").time.size(), 15u);
    EXPECT_TRUE(builtin_curve("nothing").time.empty());
}

TEST(MeasuredFronts, OfTheSameColumnDifferByMoreThanTheirZerosOfTime) {
    Curve const gate = builtin_curve("dambreak_lobovsky2014_front_H600"),
                paper = builtin_curve("dambreak_martin_moyce1952_square");
    double const last = gate.time.back(), as_they_stand = largest_difference(gate, paper, last),
                 late = fitted_lateness(gate, paper, last), after = largest_difference(gate, paper, last, late);
    fmt::print(
        "Square columns, Lobovsky et al. over Martin and Moyce: {:+.1f} %; {:+.1f} % if the latter are {:.2f} late\n",
        100 * as_they_stand, 100 * after, late);
    EXPECT_GT(as_they_stand, 0.2);
    EXPECT_GT(std::fabs(after), 0.07);
}

}  // namespace coronet
