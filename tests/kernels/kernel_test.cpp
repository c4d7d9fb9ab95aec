// SPDX-License-Identifier: BSD-3-Clause

// The kernels are piecewise polynomials of degree six at most, their pieces joined at multiples of a sixth of
// the support. So quadrature and differences of that degree are exact, and what remains is the rounding of
// the parts.
#include "coronet/kernels/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "coronet/core/simd.hpp"

namespace {

using coronet::Kernel;
using coronet::make_kernel;
using std::numbers::pi;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double supports[] = {1e-7, 1e-3, 0.3, 2.5, 1e7};

template <class Check>
void for_all_kernels(Check const& check) {
    for (auto const name : coronet::kernel_names())
        for (int D = 1; D <= 3; ++D)
            for (double const H : supports) {
                SCOPED_TRACE(std::string(name) + " in " + std::to_string(D) + "D of support " + std::to_string(H));
                check(make_kernel(name, D, H), name, D);
            }
}

/// The same kernel with the magnitude of each of its parts: what their rounding errors are proportional to.
Kernel parts(Kernel kernel) {
    for (auto& piece : kernel.c)
        for (double& c : piece) c = std::fabs(c);
    for (auto& piece : kernel.d)
        for (double& d : piece) d = -std::fabs(d);
    return kernel;
}

/// The sum of the magnitudes of all coefficients. No derivative in s = r/H of order n exceeds 6!/(6 - n)!
/// times this.
double coefficients(Kernel const& kernel) {
    double total = 0;
    for (int k = 0; k < kernel.knots; ++k)
        for (double const c : kernel.c[k]) total += std::fabs(c);
    return total;
}

double W(Kernel const& kernel, double r) { return kernel(r * r).W; }
double slope(Kernel const& kernel, double r) { return kernel(r * r).F * r; }

/// The integral of W over space, by the Gauss rule of five points (exact to degree 9) on every sixth of the
/// support.
double integral(Kernel const& kernel, int D) {
    double const near = std::sqrt(5 - 2 * std::sqrt(10. / 7)) / 3, far = std::sqrt(5 + 2 * std::sqrt(10. / 7)) / 3;
    double const near_weight = (322 + 13 * std::sqrt(70.)) / 900, far_weight = (322 - 13 * std::sqrt(70.)) / 900;
    double const node[] = {-far, -near, 0, near, far};
    double const weight[] = {far_weight, near_weight, 128. / 225, near_weight, far_weight};
    double const sphere[] = {2, 2 * pi, 4 * pi};  // area of the unit sphere in D dimensions
    double const half = kernel.support / 12;
    double total = 0;
    for (int panel = 0; panel < 6; ++panel)
        for (int k = 0; k < 5; ++k) {
            double const r = half * (2 * panel + 1 + node[k]);
            total += half * weight[k] * sphere[D - 1] * std::pow(r, D - 1) * W(kernel, r);
        }
    return total;
}

TEST(Kernel, IntegratesToOneInEveryDimension) {
    for_all_kernels([](Kernel const& kernel, auto, int D) {
        EXPECT_NEAR(integral(kernel, D), 1, 8 * eps * integral(parts(kernel), D));
    });
}

TEST(Kernel, VanishesWithItsSlopeAtAndBeyondTheEdge) {
    for_all_kernels([](Kernel const& kernel, auto, int) {
        // At the edge r/H is one but for rounding: u is at most 2 eps, W ~ u^3 and the slope ~ u^2.
        double const H = kernel.support, u = 2 * eps, most = coefficients(kernel);
        EXPECT_LE(std::fabs(W(kernel, H)), most * u * u * u);
        EXPECT_LE(std::fabs(slope(kernel, H)), 6 * most * u * u / H);
        for (double const r : {H * (1 + 8 * eps), 1.001 * H, 2 * H, 1e6 * H}) {
            EXPECT_EQ(W(kernel, r), 0) << r;
            EXPECT_EQ(slope(kernel, r), 0) << r;
        }
    });
}

TEST(Kernel, ApproachesTheEdgeWithoutAJumpOfItsSlope) {
    for_all_kernels([](Kernel const& kernel, auto, int) {
        double const H = kernel.support, most = coefficients(kernel), r = H * (1 - 1e-3);
        double const u = 1e-3 + 4 * eps;  // 1 - r/H, which carries the rounding of one
        EXPECT_GT(W(kernel, r), 0);
        EXPECT_LE(W(kernel, r), most * u * u * u);
        EXPECT_LE(-slope(kernel, r), 6 * most * u * u / H);
    });
}

TEST(Kernel, IsPositiveAndFallsEverywhereInside) {
    for_all_kernels([](Kernel const& kernel, auto, int) {
        double before = kernel.at_zero();
        for (int k = 1; k < 1000; ++k) {
            double const r = kernel.support * k / 1000;
            EXPECT_GT(W(kernel, r), 0) << r;
            EXPECT_LT(W(kernel, r), before) << r;
            EXPECT_LT(kernel(r * r).F, 0) << r;
            before = W(kernel, r);
        }
    });
}

TEST(Kernel, HasTheSlopeThatIsItsDerivative) {
    for_all_kernels([](Kernel const& kernel, auto, int) {
        // Six points differentiate degree six exactly; their span of 0.06 H stays between two joints of the
        // pieces.
        double const H = kernel.support, d = 0.01 * H;
        for (int panel = 0; panel < 12; ++panel) {
            double const r = H * (panel + 0.5) / 12;
            auto const odd = [&](int k) { return W(kernel, r + k * d) - W(kernel, r - k * d); };
            double const difference = (45 * odd(1) - 9 * odd(2) + odd(3)) / (60 * d);
            double const sum_of_parts = 2 * (45 + 9 + 1) * W(parts(kernel), r - 3 * d) / (60 * d);
            EXPECT_NEAR(slope(kernel, r), difference, 8 * eps * (sum_of_parts - slope(parts(kernel), r))) << r;
        }
    });
}

TEST(Kernel, OfAnotherSupportIsTheSameShape) {
    for_all_kernels([](Kernel const& kernel, auto name, int D) {
        Kernel const unit = make_kernel(name, D, 1);
        double const H = kernel.support, volume = std::pow(H, D);
        for (double s = 0.015; s < 1; s += 0.03) {
            auto const sum_of_parts = parts(unit)(s * s);
            // The distance itself is rounded: s by eps changes W by eps times the slope.
            double const rounding = 16 * eps * (sum_of_parts.W + s * s * std::fabs(sum_of_parts.F));
            EXPECT_NEAR(W(kernel, s * H) * volume, W(unit, s), rounding) << s;
            EXPECT_NEAR(slope(kernel, s * H) * volume * H, slope(unit, s), 16 * eps * 6 * 5 * coefficients(unit)) << s;
        }
    });
}

TEST(Kernel, AtNoDistanceIsFiniteAndPushesNowhere) {
    for_all_kernels([](Kernel const& kernel, auto, int) {
        auto const [W0, F0] = kernel(0.0);
        EXPECT_TRUE(std::isfinite(W0));
        EXPECT_GT(W0, 0);
        EXPECT_TRUE(std::isfinite(F0));
        EXPECT_EQ(F0 * 0.0, 0);
    });
}

TEST(Kernel, HasAFiniteCurvatureAtNoDistanceUnlessItIsSpiky) {
    for_all_kernels([](Kernel const& kernel, auto name, int) {
        double const H = kernel.support, s = 1e-5, third = 6 * 5 * 4 * coefficients(kernel);
        // Distances are kept above 1e-12 H. There the slope, almost zero, carries the rounding of its parts.
        double const rounding = 4 * eps * std::fabs(parts(kernel)(0.0).F) * H * H;
        double const jump = std::fabs(kernel(0.0).F - kernel(s * s * H * H).F) * H * H;
        if (name == "w3") EXPECT_GT(jump, third / s);
        else EXPECT_LT(jump, s * third + rounding);
    });
}

TEST(Kernel, HasThePublishedValues) {
    struct Published {
        char const* name;
        int D;
        double support, r, W;  // at h = 1
    };
    // Quintic and cubic spline, Wendland C2 as Morris, Monaghan and Wendland print them; W6 and W3: Lobo (2011).
    for (auto const& [name, D, support, r, value] : {
             Published{"quintic-spline", 1, 3, 0, 66. / 120},
             Published{"quintic-spline", 2, 3, 0, 66. * 7 / (478 * pi)},
             Published{"quintic-spline", 2, 3, 1, 26. * 7 / (478 * pi)},
             Published{"quintic-spline", 2, 3, 2, 7 / (478 * pi)},
             Published{"quintic-spline", 3, 3, 0, 66 / (120 * pi)},
             Published{"cubic-spline", 1, 2, 0, 2. / 3},
             Published{"cubic-spline", 2, 2, 0, 10 / (7 * pi)},
             Published{"cubic-spline", 2, 2, 1, 10 / (7 * pi) / 4},
             Published{"cubic-spline", 3, 2, 0, 1 / pi},
             Published{"wendland-c2", 1, 2, 0, 5. / 8},
             Published{"wendland-c2", 1, 2, 1, 5. / 8 / 8 * 2.5},
             Published{"wendland-c2", 2, 2, 0, 7 / (4 * pi)},
             Published{"wendland-c2", 3, 2, 0, 21 / (16 * pi)},
             Published{"wendland-c2", 3, 2, 1, 21 / (16 * pi) / 16 * 3},
             Published{"w6", 1, 1, 0, 35. / 32},
             Published{"w6", 2, 1, 0, 4 / pi},
             Published{"w6", 3, 1, 0, 315 / (64 * pi)},
             Published{"w6", 3, 1, 0.5, 315 / (64 * pi) * 27 / 64},
             Published{"w3", 1, 1, 0, 2},
             Published{"w3", 2, 1, 0, 10 / pi},
             Published{"w3", 3, 1, 0, 15 / pi},
             Published{"w3", 3, 1, 0.5, 15 / pi / 8},
         })
        for (double const h : supports) {
            SCOPED_TRACE(std::string(name) + " in " + std::to_string(D) + "D at r/h = " + std::to_string(r));
            Kernel const kernel = make_kernel(name, D, support * h);
            // Zero distance is read as 1e-12 of the support.
            double const above_zero = 1e-12 * support * h * std::fabs(slope(kernel, 1e-12 * support * h));
            double const rounding = 8 * eps * (W(parts(kernel), r * h) - r * h * slope(parts(kernel), r * h));
            EXPECT_NEAR(W(kernel, r * h), value / std::pow(h, D), rounding + (r == 0 ? above_zero : 0));
        }
}

TEST(Kernel, WithoutSlopeAtTheCentreHasItsCurvatureThereForTheSlopeOverR) {
    for (auto const& [name, curvature] : {std::pair{"wendland-c2", -20.0}, {"w6", -6.0}})  // of W/W(0) at H = 1
        for (double const H : supports) {
            Kernel const kernel = make_kernel(name, 3, H);
            EXPECT_TRUE(kernel.is_polynomial);
            double const expected = curvature * kernel.at_zero() / (H * H);
            // It is taken at 1e-12 H, where it has fallen by at most three times that.
            EXPECT_NEAR(kernel(0.0).F, expected, 4e-12 * std::fabs(expected)) << name;
        }
    for (auto const name : {"w3", "cubic-spline", "quintic-spline"})
        EXPECT_FALSE(make_kernel(name, 3, 1).is_polynomial);
}

TEST(Kernel, TellsAPackOfDistancesWhatItTellsEachAlone) {
    for_all_kernels([](Kernel const& kernel, auto, int) {
        auto const expect_alike = [&]<class T>(T rounding) {
            // With packs of float not at r = 0 of a spline, where the slope is a difference of large numbers.
            for (int start = sizeof(T) == 4 && !kernel.is_polynomial; start < 40; start += coronet::pack_size<T>) {
                T r2[coronet::pack_size<T>];
                for (int k = 0; k < coronet::pack_size<T>; ++k)
                    r2[k] = static_cast<T>(std::pow(kernel.support * 1.2 * (start + k) / 40, 2));
                auto const values = kernel(coronet::load(r2));
                auto const known =
                    kernel.is_polynomial ? kernel.at<true>(coronet::load(r2)) : kernel.at<false>(coronet::load(r2));
                for (int k = 0; k < coronet::pack_size<T>; ++k) {
                    auto const sum_of_parts = parts(kernel)(static_cast<double>(r2[k]));
                    auto const alone = kernel(static_cast<double>(r2[k]));
                    // Near the edge 1 - r/H has few digits left.
                    double const edge = std::max(1 - std::sqrt(static_cast<double>(r2[k])) / kernel.support, 0.01);
                    double const W = rounding / edge * sum_of_parts.W, F = rounding / edge * std::fabs(sum_of_parts.F);
                    EXPECT_NEAR(values.W[k], alone.W, W) << start + k;
                    EXPECT_NEAR(values.F[k], alone.F, F) << start + k;
                    EXPECT_NEAR(known.W[k], alone.W, W) << start + k;
                    EXPECT_NEAR(known.F[k], alone.F, F) << start + k;
                }
            }
        };
        expect_alike(8 * eps);
        expect_alike(8 * std::numeric_limits<float>::epsilon());
    });
}

TEST(Kernel, IsOneOfFiveNames) {
    std::vector<std::string_view> const names(coronet::kernel_names().begin(), coronet::kernel_names().end());
    EXPECT_EQ(names, (std::vector<std::string_view>{"quintic-spline", "cubic-spline", "wendland-c2", "w6", "w3"}));
}

TEST(Kernel, OfAnUnknownNameIsRefusedByName) {
    for (std::string const name : {"", "gaussian", "Quintic-Spline", "w"}) {
        try {
            make_kernel(name, 2, 1);
            FAIL() << name;
        } catch (std::invalid_argument const& error) {
            EXPECT_NE(std::string(error.what()).find("'" + name + "'"), std::string::npos);
        }
    }
}

}  // namespace
