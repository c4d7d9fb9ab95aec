// SPDX-License-Identifier: BSD-3-Clause

// The terms that make up the one-sweep form of plain SPH.

#include <gtest/gtest.h>

#include "coronet/terms/artificial_viscosity.hpp"
#include "coronet/terms/continuity.hpp"
#include "coronet/terms/morris_viscosity.hpp"
#include "coronet/terms/pressure_gradient.hpp"
#include "coronet/terms/stress_divergence.hpp"
#include "tests/terms/random_pair.hpp"

namespace coronet {

TEST(PressureGradient, IsTheStressDivergenceOfPressureAlone) {
    for (auto const& ij : random_pairs<3, Sum<PressureGradient, StressDivergence>>(100)) {
        auto stressed = ij;
        stressed.i.sigma = {{-ij.i.p, -ij.i.p, -ij.i.p, 0, 0, 0}};
        stressed.j.sigma = {{-ij.j.p, -ij.j.p, -ij.j.p, 0, 0, 0}};
        auto const a = Sum<PressureGradient>{}(ij).dv, b = StressDivergence{}(stressed).dv;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-15 * std::sqrt(norm2(b)));
    }
}

TEST(Continuity, IsMinusDensityTimesTheDivergenceAndKnowsNoCommonVelocity) {
    for (auto ij : random_pairs<2, Continuity>(100)) {
        auto const jump = ij.j.v - ij.i.v;
        EXPECT_NEAR(Continuity{}(ij).drho, -ij.i.rho * ij.j.V * dot(jump, ij.gradW),
                    1e-14 * std::sqrt(norm2(ij.gradW)));
        ij.j.v = ij.i.v;
        EXPECT_EQ(Continuity{}(ij).drho, 0);
    }
}

TEST(MorrisViscosity, IsEqualAndOppositeAndOnlyTakesEnergy) {
    MorrisViscosity const viscosity{.eta = 0.7};
    for (auto const& ij : random_pairs<3, MorrisViscosity>(1000)) {
        auto const ji = swapped(ij);
        auto const on_i = (ij.i.rho * ij.i.V) * viscosity(ij).dv, on_j = (ji.i.rho * ji.i.V) * viscosity(ji).dv;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(on_i[k], -on_j[k], 2e-15 * std::sqrt(norm2(on_i)));
        EXPECT_LT(dot(on_i, ij.i.v - ij.j.v), 0);
    }
}

TEST(Sum, OfTermsGivesWhatEachGivesWhetherCentralOrNot) {
    ArtificialViscosity const artificial{.alpha = 0.3, .beta = 0.7};
    MorrisViscosity const morris{.eta = 0.7};
    Sum<MorrisViscosity, PressureGradient, Continuity, Sum<ArtificialViscosity>> const law{
        morris, {}, {}, Sum{artificial}};
    for (auto const& ij : random_pairs<3, decltype(law)>(1000)) {
        auto const together = law(ij);
        auto const a = Sum<PressureGradient>{}(ij).dv, b = Sum{artificial}(ij).dv, c = morris(ij).dv;
        double const size = std::sqrt(norm2(a)) + std::sqrt(norm2(b)) + std::sqrt(norm2(c));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(together.dv[k], a[k] + b[k] + c[k], 1e-15 * size);
        EXPECT_EQ(together.drho, Continuity{}(ij).drho);
    }
}

}  // namespace coronet
