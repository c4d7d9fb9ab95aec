// SPDX-License-Identifier: BSD-3-Clause

// Operations that are counted are those that one counts on paper.
#include "coronet/run/counted.hpp"

#include <gtest/gtest.h>

#include "coronet/terms/pressure_gradient.hpp"

namespace coronet {

namespace {

template <class Act>
std::int64_t operations_of(Act const& act) {
    Counted::operations = 0;
    act();
    return Counted::operations;
}

TEST(Counted, CountsEachOperationOnce) {
    Counted const a(3, true), b(4, true);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((a + b).value, 7); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((a - b).value, -1); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((a * b).value, 12); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((a / b).value, 0.75); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((-a).value, -3); }), 0);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ(largest(a, b).value, 4); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ(smallest(a, b).value, 3); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ(square_root(b).value, 2); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ(inverse_root(b).value, 0.5); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ(select(a < b, a, b).value, 3); }), 2);
    // Horner's rule for a cubic: three multiplications and three additions.
    Counted const c(2);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((c + a * (c + a * (c + a * c))).value, 80); }), 6);
}

TEST(Counted, LeavesOutWhatIsTheSameForAllNeighbours) {
    Counted const fixed(3), constant(4), varying(5, true);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((fixed * constant / Counted(2)).value, 6); }), 0);
    EXPECT_EQ(operations_of([&] { EXPECT_EQ((fixed * constant * varying).value, 60); }), 1);
    EXPECT_EQ(operations_of([&] { EXPECT_TRUE((fixed + varying).varies); }), 1);
}

TEST(Counted, SumsOfTensorsCountTheirComponents) {
    Vector<Counted, 3> a, b;
    for (int k = 0; k < 3; ++k) a[k] = b[k] = Counted(1, true);
    EXPECT_EQ(operations_of([&] { (void)(a - b); }), 3);
    EXPECT_EQ(operations_of([&] { (void)dot(a, b); }), 5);
}

/// x_i - x_j D, its square 2 D - 1, the kernel, its gradient D; of the pressure gradient p_i + p_j, times V_j, times
/// 1/rho_i (the same for all neighbours), times the gradient 3 + D; into the sum of terms D, into the sum of pairs D.
/// The kernel: bound of r^2, inverse root, s (two), slope over r: 5; per knot the difference and its bound 2, its
/// square and cube 2, W and its slope each three multiply-adds, a product and a sum, 8.
TEST(OperationsPerPair, OfThePressureGradientAreThoseOnPaper) {
    Sum<PressureGradient> const law;
    for (auto const& [name, knots] : {std::pair{"wendland-c2", 1}, {"cubic-spline", 2}, {"quintic-spline", 3}}) {
        int const kernel = 5 + (2 + 2 + 8 + 8) * knots;
        EXPECT_EQ(operations_per_pair<2>(make_kernel(name, 2, 1), law), 2 + 3 + kernel + 2 + (3 + 2) + 2 + 2) << name;
        EXPECT_EQ(operations_per_pair<3>(make_kernel(name, 3, 1), law), 3 + 5 + kernel + 3 + (3 + 3) + 3 + 3) << name;
    }
}

}  // namespace

}  // namespace coronet
