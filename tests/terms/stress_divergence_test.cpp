// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/terms/stress_divergence.hpp"

#include <gtest/gtest.h>

#include "tests/terms/random_pair.hpp"

namespace coronet {

/// The force on i [N] of a term for which m = rho V, and the sum of the sizes of its parts.
template <class Term, class P>
auto force(P const& ij) {
    return (ij.i.rho * ij.i.V) * Term{}(ij).dv;
}

template <class Term, int D>
void expect_equal_and_opposite() {
    for (auto ij : random_pairs<D, Term>(1000)) {
        auto const on_i = force<Term>(ij), on_j = force<Term>(swapped(ij));
        double const size = std::sqrt(norm2(on_i));
        for (int k = 0; k < D; ++k) EXPECT_NEAR(on_i[k], -on_j[k], 4e-15 * (size + 1));
    }
}

TEST(StressDivergence, IsEqualAndOpposite) {
    expect_equal_and_opposite<StressDivergence, 2>();
    expect_equal_and_opposite<StressDivergence, 3>();
}

TEST(CorrectedStressDivergence, IsEqualAndOpposite) {
    expect_equal_and_opposite<CorrectedStressDivergence, 2>();
    expect_equal_and_opposite<CorrectedStressDivergence, 3>();
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
        ij.x = plain.x, ij.r2 = plain.r2, ij.W = plain.W, ij.gradW = plain.gradW;
        ij.i.rho = plain.i.rho, ij.j.V = plain.j.V;
        ij.i.T = product<double, 3>(plain.i.sigma, identity<double, 3>());
        ij.j.T = product<double, 3>(plain.j.sigma, identity<double, 3>());
        ij.i.s = ij.j.s = {};
        auto const a = CorrectedStressDivergence{}(ij).dv, b = StressDivergence{}(plain).dv;
        for (int k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(a[k], b[k]);
    }
}

}  // namespace coronet
