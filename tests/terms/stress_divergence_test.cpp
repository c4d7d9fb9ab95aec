// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/terms/stress_divergence.hpp"

#include <gtest/gtest.h>

#include "tests/terms/random_pair.hpp"

namespace coronet {

/// The force on i [N] if j were its only neighbour.
auto force(StressDivergence const& term, auto const& ij) { return (ij.i.rho * ij.i.V) * term(ij).dv; }

/// The pairs have random V T and V s; of T_i and s_i comes the part that i adds itself.
template <class P>
auto force(CorrectedStressDivergence const& term, P const& ij, double V_i, double V_j) {
    auto const own = term.own_part((1 / V_i) * ij.i.VT, (1 / V_i) * ij.i.Vs, ij.i.rho, V_j * ij.gradW, V_j * ij.W);
    return (ij.i.rho * V_i) * (own + term(ij).dv);
}

template <int D>
void expect_equal_and_opposite() {
    for (auto const& ij : random_pairs<D, StressDivergence>(1000)) {
        auto const on_i = force({}, ij), on_j = force({}, swapped(ij));
        for (int k = 0; k < D; ++k) EXPECT_NEAR(on_i[k], -on_j[k], 4e-15 * (std::sqrt(norm2(on_i)) + 1));
    }
    for (auto const& ij : random_pairs<D, CorrectedStressDivergence>(1000)) {
        double const V_i = 0.7, V_j = 1.2;
        auto const on_i = force({}, ij, V_i, V_j), on_j = force({}, swapped(ij), V_j, V_i);
        for (int k = 0; k < D; ++k) EXPECT_NEAR(on_i[k], -on_j[k], 4e-15 * (std::sqrt(norm2(on_i)) + 1));
    }
}

TEST(StressDivergence, IsEqualAndOppositePlainAndCorrected) {
    expect_equal_and_opposite<2>();
    expect_equal_and_opposite<3>();
}

TEST(StressDivergence, OfPressureAlonePushesApartAlongThePair) {
    for (auto ij : random_pairs<2, StressDivergence>(100)) {
        ij.i.sigma = {{-2, -2, 0}};
        ij.j.sigma = {{-3, -3, 0}};
        auto const dv = StressDivergence{}(ij).dv;
        EXPECT_GT(dot(dv, ij.x), 0);
        EXPECT_NEAR(ij.x[0] * dv[1] - ij.x[1] * dv[0], 0, 4e-16 * std::sqrt(norm2(ij.x) * norm2(dv)));
    }
}

TEST(CorrectedStressDivergence, WithoutCorrectionIsThePlainOne) {
    auto const plain_pairs = random_pairs<3, StressDivergence>(100);
    auto corrected_pairs = random_pairs<3, CorrectedStressDivergence>(100);
    for (std::size_t n = 0; n < plain_pairs.size(); ++n) {
        auto const& plain = plain_pairs[n];
        auto& ij = corrected_pairs[n];
        ij.x = plain.x, ij.r2 = plain.r2, ij.W = plain.W, ij.F = plain.F, ij.gradW = plain.gradW;
        ij.i.rho = plain.i.rho;
        auto const full = [](auto const& sigma) { return product<double, 3>(sigma, identity<double, 3>()); };
        ij.i.VT = plain.i.V * full(plain.i.sigma);
        ij.j.VT = plain.j.V * full(plain.j.sigma);
        ij.i.Vs = ij.j.Vs = {};
        auto const a = force({}, ij, plain.i.V, plain.j.V), b = force({}, plain);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 4e-15 * (std::sqrt(norm2(b)) + 1));
    }
}

}  // namespace coronet
