// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/solvers/conjugate_gradients.hpp"

#include <gtest/gtest.h>

#include "coronet/solvers/jacobi.hpp"

namespace coronet {

namespace {

/// -u'' with u = 0 at both ends, times a scale that differs from row to row on both sides: symmetric.
struct Rod {
    std::vector<double> scale;
    bool fixed = true;

    std::size_t size() const { return scale.size(); }
    void operator()(std::span<double const> x, std::span<double> y) const {
        auto const at = [&](std::size_t i) { return scale[i] * x[i]; };
        for (std::size_t i = 0; i < size(); ++i) {
            bool const first = i == 0, last = i + 1 == size();
            double const sides = fixed ? 2 : 2.0 - first - last;
            y[i] = scale[i] * (sides * at(i) - (first ? 0 : at(i - 1)) - (last ? 0 : at(i + 1)));
        }
    }
    std::vector<double> diagonal() const {
        std::vector<double> d;
        for (double const s : scale) d.push_back(2 * s * s);
        return d;
    }
};

Rod rod(std::size_t n, double range) {
    Rod r{std::vector<double>(n)};
    for (std::size_t i = 0; i < n; ++i) r.scale[i] = std::pow(range, static_cast<double>(i * 7 % n) / n);
    return r;
}

constexpr auto nothing = [](std::span<double const> r, std::span<double> z) {
    std::copy(r.begin(), r.end(), z.begin());
};

}  // namespace

TEST(ConjugateGradients, EndWithinAsManyIterationsAsThereAreUnknowns) {
    Rod const A = rod(40, 1);
    std::vector<double> b(40), x(40, 0.0), Ax(40);
    for (std::size_t i = 0; i < 40; ++i) b[i] = std::sin(static_cast<double>(i * i));
    auto const solved = ConjugateGradients().solve(A, nothing, b, x, {1e-12, 100});
    EXPECT_TRUE(solved.converged);
    EXPECT_LE(solved.iterations, 40);
    A(x, Ax);
    for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(Ax[i], b[i], 1e-11);
}

TEST(ConjugateGradients, WithJacobiDoNotCareForTheUnitsOfARow) {
    Rod const even = rod(200, 1), uneven = rod(200, 1e4);
    auto const iterations = [](Rod const& A) {
        std::vector<double> b(200), x(200, 0.0);
        for (std::size_t i = 0; i < 200; ++i) b[i] = A.scale[i] * std::sin(static_cast<double>(i * i));
        auto const d = A.diagonal();
        return ConjugateGradients().solve(A, Jacobi{d}, b, x, {1e-10, 1000}).iterations;
    };
    EXPECT_NEAR(iterations(even), iterations(uneven), 25);
}

TEST(ConjugateGradients, FromTheSolutionNeedNoIteration) {
    Rod const A = rod(50, 1);
    std::vector<double> b(50), x(50, 0.0);
    for (std::size_t i = 0; i < 50; ++i) b[i] = std::cos(static_cast<double>(i));
    ConjugateGradients().solve(A, nothing, b, x, {1e-12, 100});
    EXPECT_EQ(ConjugateGradients().solve(A, nothing, b, x, {1e-8, 100}).iterations, 0);
}

TEST(ConjugateGradients, LeaveWhatTheOperatorCannotSeeAsItWas) {
    // Both ends free: a constant has no effect. b sums to zero, and so is in the range.
    Rod A = rod(50, 1);
    A.fixed = false;
    std::vector<double> b(50, 0.0), x(50, 3.0);
    b[3] = 1, b[40] = -1;
    auto const solved = ConjugateGradients().solve(A, nothing, b, x, {1e-12, 100});
    EXPECT_TRUE(solved.converged);
    EXPECT_NEAR(sum_over(50, 0.0, [&](std::size_t i) { return x[i]; }), 150, 1e-10);
}

TEST(ConjugateGradients, SayThatTheyHaveNotConverged) {
    Rod A = rod(50, 1);
    std::vector<double> b(50, 1.0), x(50, 0.0);
    auto const cut = ConjugateGradients().solve(A, nothing, b, x, {1e-10, 7});
    EXPECT_FALSE(cut.converged);
    EXPECT_FALSE(cut.broke_down);
    EXPECT_EQ(cut.iterations, 7);
    EXPECT_GT(cut.residual, 1e-10);
}

TEST(ConjugateGradients, TellABreakdownFromTooFewIterations) {
    auto const end = [](auto const& A, std::vector<double> const& b) {
        std::vector<double> x(b.size(), 0.0);
        Solved const solved = ConjugateGradients().solve(A, nothing, b, x, {1e-10, 1000});
        EXPECT_FALSE(solved.converged);
        EXPECT_TRUE(solved.broke_down);
        return solved.iterations;
    };
    Rod A = rod(50, 1);
    A.fixed = false;  // what is constant it cannot see: not in its range
    EXPECT_EQ(end(A, std::vector<double>(50, 1.0)), 1);
    auto const indefinite = [](std::span<double const> in, std::span<double> out) {
        out[0] = in[0], out[1] = -3 * in[1];
    };
    EXPECT_EQ(end(indefinite, {1, 1}), 1);
    A.fixed = true;
    std::vector<double> b(50, 1.0);
    b[10] = NAN;
    EXPECT_EQ(end(A, b), 1) << "noticed at once";
    b[10] = INFINITY;
    EXPECT_EQ(end(A, b), 1);
}

TEST(ConjugateGradients, OfNothingAreNothing) {
    Rod const A = rod(10, 1);
    std::vector<double> b(10, 0.0), x(10, 5.0);
    EXPECT_TRUE(ConjugateGradients().solve(A, nothing, b, x).converged);
    EXPECT_EQ(x, std::vector<double>(10, 0.0));
}

}  // namespace coronet
