// SPDX-License-Identifier: BSD-3-Clause

// Operations that are counted are those that one counts on paper.
#include "coronet/run/counted.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include "coronet/terms/pressure_gradient.hpp"

namespace coronet {

namespace {

std::int64_t operations_for(Counted const& result) { return Counted::operations_for({result}); }

Counted varying(double value) { return Counted::quantity(value, true); }

TEST(Counted, CountsEachOperation) {
    Counted const a = varying(3), b = varying(4);
    for (auto const& [result, value, operations] :
         std::vector<std::tuple<Counted, double, int>>{{a, 3, 0},
                                                       {a + b, 7, 1},
                                                       {a - b, -1, 1},
                                                       {a * b, 12, 1},
                                                       {a / b, 0.75, 1},
                                                       {-a, -3, 0},
                                                       {a - -b, 7, 1},
                                                       {largest(a, b), 4, 1},
                                                       {smallest(a, b), 3, 1},
                                                       {square_root(b), 2, 1},
                                                       {roots(b).root, 2, 1},
                                                       {roots(b).inverse, 0.5, 2},
                                                       {select(a < b, a, b), 3, 2},
                                                       {2 + a * (2 + a * (2 + a * 2)), 80, 6}}) {
        EXPECT_EQ(result.value, value);
        EXPECT_EQ(operations_for(result), operations) << value;
    }
}

TEST(Counted, LeavesOutWhatIsTheSameForAllNeighbours) {
    Counted const fixed = Counted::quantity(3, false), b = varying(5);
    EXPECT_EQ(operations_for(fixed * 4 / 2), 0);
    EXPECT_EQ(operations_for(fixed * 4 * b), 1);
    EXPECT_TRUE((fixed + b).varies);
}

TEST(Counted, CountsWhatOccursTwiceOnceAndWhatIsNotNeededNever) {
    Counted const a = varying(3), b = varying(4);
    EXPECT_EQ(operations_for((a + b) * (a + b)), 2);
    EXPECT_EQ(operations_for((a + b) * (a - b)), 3);
    [[maybe_unused]] Counted const unused = a * b * a;
    EXPECT_EQ(operations_for(a + b), 1);
    EXPECT_EQ(Counted::operations_for({a + b, (a + b) * a}), 2);
}

TEST(Counted, SumsOfTensorsCountTheirComponents) {
    Vector<Counted, 3> a, b;
    for (int k = 0; k < 3; ++k) a[k] = varying(1), b[k] = varying(1);
    auto const d = a - b;
    EXPECT_EQ(Counted::operations_for({d[0], d[1], d[2]}), 3);
    EXPECT_EQ(operations_for(dot(a, b)), 5);
}

/// x_i - x_j D, its square 2 D - 1; the kernel's slope over r, for W is not needed: of a spline r^2 bounded, root,
/// inverse, s, slope over r, 5, and per knot the difference and its bound 2, its square 1, a multiply-add 2, times the
/// square 1, and the sum 1; of a polynomial r^2 bounded, root, s, the difference and its bound 5, its square 1, two
/// multiply-adds 4, times the square 1; of the pressure gradient p_i + p_j, times 1/rho_i, V_j F, times that: 4; times
/// x_ij and into the sum 2 D.
TEST(OperationsPerPair, OfThePressureGradientAreThoseOnPaper) {
    Sum<PressureGradient> const law;
    for (auto const& [name, knots] : {std::pair{"wendland-c2", 1}, {"cubic-spline", 2}, {"quintic-spline", 3}}) {
        int const kernel = knots == 1 ? 5 + 1 + 4 + 1 : 5 + 7 * knots;
        EXPECT_EQ(operations_per_pair<2>(make_kernel(name, 2, 1), law), 2 + 3 + kernel + 4 + 4) << name;
        EXPECT_EQ(operations_per_pair<3>(make_kernel(name, 3, 1), law), 3 + 5 + kernel + 4 + 6) << name;
    }
}

}  // namespace

}  // namespace coronet
