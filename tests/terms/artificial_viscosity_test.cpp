// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/terms/artificial_viscosity.hpp"

#include <gtest/gtest.h>

#include "coronet/core/simd.hpp"
#include "tests/terms/random_pair.hpp"

namespace coronet {

constexpr Sum<ArtificialViscosity> viscosity{{.alpha = 0.3, .beta = 0.7}};

TEST(ArtificialViscosity, IsEqualAndOpposite) {
    for (auto const& ij : random_pairs<3, ArtificialViscosity>(1000)) {
        auto const ji = swapped(ij);
        for (int k = 0; k < 3; ++k) {
            double const on_i = ij.i.rho * ij.i.V * viscosity(ij).dv[k];
            double const on_j = ji.i.rho * ji.i.V * viscosity(ji).dv[k];
            EXPECT_NEAR(on_i, -on_j, 2e-15 * std::fabs(on_i));
        }
    }
}

TEST(ArtificialViscosity, IsIdleWithoutCoefficients) {
    Sum<ArtificialViscosity> const none;
    EXPECT_FALSE(none.active());
    for (auto const& ij : random_pairs<3, ArtificialViscosity>(10)) EXPECT_EQ(norm2(none(ij).dv), 0);
}

TEST(ArtificialViscosity, PointsAlongThePairSoItHasNoTorque) {
    for (auto const& ij : random_pairs<2, ArtificialViscosity>(1000)) {
        auto const dv = viscosity(ij).dv;
        EXPECT_NEAR(ij.x[0] * dv[1] - ij.x[1] * dv[0], 0, 8e-16 * std::sqrt(norm2(ij.x) * norm2(dv)));
    }
}

TEST(ArtificialViscosity, TakesEnergyFromApproachAndNoneFromParting) {
    int approaching = 0;
    for (auto const& ij : random_pairs<2, ArtificialViscosity>(1000)) {
        double const power = ij.i.rho * ij.i.V * dot(viscosity(ij).dv, ij.i.v - ij.j.v);
        if (dot(ij.i.v - ij.j.v, ij.x) < 0) {
            EXPECT_LT(power, 0);
            ++approaching;
        } else {
            EXPECT_EQ(power, 0);
        }
    }
    EXPECT_GT(approaching, 300);
    EXPECT_LT(approaching, 700);
}

TEST(ArtificialViscosity, HasTheValueOfThePaperForOnePair) {
    auto ij = random_pairs<2, ArtificialViscosity>(1).front();
    ij.i.c = 10, ij.j.c = 20, ij.i.rho = 900, ij.j.rho = 1100, ij.j.V = 2.0 / 1100;
    ij.x = {{3, 4}}, ij.r2 = 25, ij.h = 10, ij.F = -2;
    ij.i.v = {{-1, 0}}, ij.j.v = {{0, 0}};
    double const phi = 10 * -3.0 / (25 + 0.01 * 100), Pi = (-0.3 * 15 * phi + 0.7 * phi * phi) / 1000;
    EXPECT_DOUBLE_EQ(viscosity(ij).dv[0], -2 * Pi * -6);
    EXPECT_DOUBLE_EQ(viscosity(ij).dv[1], -2 * Pi * -8);
}

TEST(ArtificialViscosity, HasInFloatTheValueOfDoubleForEveryKernelRadiusThatACaseMayHave) {
    using Float = Pack<float>;
    for (auto ij : random_pairs<3, ArtificialViscosity>(100))
        for (double const H : {1e-7, 1e-3, 1.0, 1e7}) {
            auto scaled = ij;
            scaled.x = H * ij.x, scaled.r2 = H * H * ij.r2, scaled.h = H * ij.h;
            scaled.i.v = 1e4 * ij.i.v, scaled.i.c = 1e4 * ij.i.c, scaled.i.rho = 1e3 * ij.i.rho;
            scaled.j.v = 1e4 * ij.j.v, scaled.j.c = 1e4 * ij.j.c, scaled.j.rho = 1e3 * ij.j.rho;
            Pair<Float, 3, ArtificialViscosity::reads, ArtificialViscosity::reads> rounded;
            rounded.x = numbers<Float>(scaled.x), rounded.r2 = scaled.r2, rounded.h = scaled.h;
            auto const round = [](auto const& from, auto& to) {
                to.v = numbers<Float>(from.v), to.c = from.c, to.rho = from.rho, to.V = from.V;
            };
            round(scaled.i, rounded.i);
            round(scaled.j, rounded.j);
            double const exact = viscosity.central(scaled), alpha_c_v = 0.3 * 1e4 * 1e4;
            EXPECT_NEAR(static_cast<double>(viscosity.central(rounded)[0]), exact,
                        1e-5 * (std::fabs(exact) + alpha_c_v))
                << H;
        }
}

}  // namespace coronet
