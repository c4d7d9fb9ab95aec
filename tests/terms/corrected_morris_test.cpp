// SPDX-License-Identifier: BSD-3-Clause

// The terms of the conservative equations of Jahanbakhsh et al. (2012) with corrected kernels.

#include <gtest/gtest.h>

#include "coronet/terms/corrected_pressure_gradient.hpp"
#include "coronet/terms/morris_viscosity.hpp"
#include "coronet/terms/pressure_gradient.hpp"
#include "tests/terms/random_pair.hpp"

namespace coronet {

namespace {

/// The same pair with plain gradients.
template <class P>
P plain(P ij) {
    ij.i.L = ij.j.L = identity<double, 3>();
    ij.i.q = ij.j.q = {};
    return ij;
}

}  // namespace

TEST(CorrectedPressureGradient, IsEqualAndOpposite) {
    for (auto const& ij : random_pairs<3, CorrectedPressureGradient>(1000)) {
        auto const ji = swapped(ij);
        auto const on_i = (ij.i.rho * ij.i.V) * CorrectedPressureGradient{}(ij).dv,
                   on_j = (ji.i.rho * ji.i.V) * CorrectedPressureGradient{}(ji).dv;
        double const size = ij.i.V * ij.j.V * 3 * (std::sqrt(norm2(ij.gradW)) + ij.W);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(on_i[k], -on_j[k], 1e-15 * size);
    }
}

TEST(CorrectedPressureGradient, IsThePlainOneWithoutCorrection) {
    for (auto const& ij : random_pairs<3, Sum<CorrectedPressureGradient, PressureGradient>>(100)) {
        auto const a = CorrectedPressureGradient{}(plain(ij)).dv, b = Sum<PressureGradient>{}(ij).dv;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 2e-15 * std::sqrt(norm2(b)));
    }
}

TEST(CorrectedMorrisViscosity, IsEqualAndOppositeAlongTheRelativeVelocity) {
    CorrectedMorrisViscosity const viscosity{.eta = 0.7};
    for (auto const& ij : random_pairs<3, CorrectedMorrisViscosity>(1000)) {
        auto const ji = swapped(ij);
        auto const on_i = (ij.i.rho * ij.i.V) * viscosity(ij).dv, on_j = (ji.i.rho * ji.i.V) * viscosity(ji).dv;
        auto const v = ij.i.v - ij.j.v;
        double const soft = 1 / (ij.r2 + 0.01 * ij.h * ij.h);
        double const size = soft * (ij.r2 * std::fabs(ij.F) * 3 + ij.W) * std::sqrt(ij.r2 * norm2(v));
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(on_i[k], -on_j[k], 1e-14 * size);
            EXPECT_NEAR(on_i[k] * v[(k + 1) % 3], on_i[(k + 1) % 3] * v[k], 1e-14 * size * std::sqrt(norm2(v)));
        }
    }
}

TEST(CorrectedMorrisViscosity, IsThePlainOneWithoutCorrection) {
    for (auto const& ij : random_pairs<3, Sum<CorrectedMorrisViscosity, MorrisViscosity>>(100)) {
        auto const a = CorrectedMorrisViscosity{.eta = 0.7}(plain(ij)).dv, b = MorrisViscosity{.eta = 0.7}(ij).dv;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 5e-15 * std::sqrt(norm2(b)));
    }
}

}  // namespace coronet
