// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/terms/central_viscosity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/terms/random_pair.hpp"

namespace coronet {

constexpr Sum<CentralViscosity> viscosity{{.share = 1}};

TEST(CentralViscosity, IsEqualAndOppositeAlongThePairAndTakesEnergy) {
    for (auto const& ij : random_pairs<3, CentralViscosity>(1000)) {
        auto const ji = swapped(ij);
        auto const on_i = ij.i.rho * ij.i.V * viscosity(ij).dv, on_j = ji.i.rho * ji.i.V * viscosity(ji).dv;
        double const size = std::sqrt(norm2(on_i));
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(on_i[k], -on_j[k], 2e-15 * size);
            int const l = (k + 1) % 3;
            EXPECT_NEAR(ij.x[k] * on_i[l] - ij.x[l] * on_i[k], 0, 2e-15 * size * std::sqrt(norm2(ij.x)));
        }
        EXPECT_LE(dot(on_i, ij.i.v - ij.j.v), 0);
    }
}

TEST(CentralViscosity, IsTheHarmonicMeanOfBoth) {
    auto ij = random_pairs<3, CentralViscosity>(1).front();
    auto const size_with = [&](double mu_i, double mu_j) {
        ij.i.mu = mu_i, ij.j.mu = mu_j;
        return std::sqrt(norm2(viscosity(ij).dv));
    };
    double const even = size_with(0.3, 0.3);
    EXPECT_NEAR(size_with(0.2, 0.6), even, 1e-14 * even);
    EXPECT_EQ(size_with(0, 0.6), 0);
    EXPECT_EQ(size_with(0, 0), 0);
}

TEST(CentralViscosity, OfALinearFlowDissipatesAsTheStressDoes) {
    // Around a particle on a lattice, of the velocity A x: half of sum_j f_ij . v_ij is 2 mu d : d, d the symmetric
    // part of A without divergence.
    double const A[3][3] = {{1, 0.4, -0.3}, {0.2, -0.7, 0.5}, {-0.1, 0.9, -0.3}};
    double expected = 0, found = 0;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) expected += 2 * 0.3 * std::pow((A[a][b] + A[b][a]) / 2, 2);
    auto ij = random_pairs<3, CentralViscosity>(1).front();
    ij.i.v = {}, ij.i.rho = 1, ij.j.V = 1, ij.i.mu = ij.j.mu = 0.3;
    double const H = 8;  // spacings, wide enough for a sum to be an integral
    for (int x = -8; x <= 8; ++x)
        for (int y = -8; y <= 8; ++y)
            for (int z = -8; z <= 8; ++z) {
                double const r2 = x * x + y * y + z * z, r = std::sqrt(r2), s = 1 - r / H;
                if (r2 == 0 || s <= 0) continue;
                ij.x = {{-1.0 * x, -1.0 * y, -1.0 * z}};  // x_i - x_j
                ij.r2 = r2;
                double const W0 = 21 / (2 * std::numbers::pi * H * H * H);  // Wendland C2: (1 - q)^4 (1 + 4 q)
                ij.F = W0 * -20 / (H * H) * s * s * s;
                for (int a = 0; a < 3; ++a) ij.j.v[a] = A[a][0] * x + A[a][1] * y + A[a][2] * z;
                found += 0.5 * dot(viscosity(ij).dv, ij.j.v);
            }
    EXPECT_NEAR(found, expected, 0.01 * expected);
}

}  // namespace coronet
