// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "coronet/materials/equation_of_state.hpp"
#include "coronet/materials/generalised_newtonian.hpp"

namespace {

using coronet::EquationOfState, coronet::Newtonian, coronet::Matrix, coronet::Symmetric;
using Kind = EquationOfState::Kind;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Water and a thin, slow liquid. Whole exponents up to 7: the pressure is a polynomial of the density.
std::vector<EquationOfState> liquids() {
    std::vector<EquationOfState> list;
    for (auto const kind : {Kind::linear, Kind::tait})
        for (double const gamma : {1.0, 3.0, 7.0}) {
            list.push_back({.kind = kind, .rho0 = 1000, .c = 1400, .gamma = gamma});
            list.push_back({.kind = kind, .rho0 = 0.7, .c = 0.03, .gamma = gamma});
        }
    return list;
}

/// The magnitudes whose difference the pressure is [Pa]; a power of gamma passes gamma times the rounding of
/// its base.
double parts(EquationOfState const& liquid, double rho) {
    double const ratio = rho / liquid.rho0, scale = liquid.rho0 * liquid.c * liquid.c;
    return liquid.kind == Kind::linear ? scale * (ratio + 1) : scale * (std::pow(ratio, liquid.gamma) + 1);
}

/// dp/drho by differences of eight points, exact for polynomials of degree eight.
double slope(EquationOfState const& liquid, double rho, double d) {
    auto const odd = [&](int k) { return liquid.pressure(rho + k * d) - liquid.pressure(rho - k * d); };
    return (672 * odd(1) - 168 * odd(2) + 32 * odd(3) - 3 * odd(4)) / (840 * d);
}

TEST(EquationOfState, HasNoPressureAtTheReferenceDensity) {
    for (auto const& liquid : liquids()) {
        EXPECT_EQ(liquid.pressure(liquid.rho0), 0);
        EXPECT_EQ(liquid.density(0), liquid.rho0);
        EXPECT_EQ(liquid.sound_speed(liquid.rho0), liquid.c);
    }
}

TEST(EquationOfState, GivesBackTheDensityWhosePressureItGave) {
    for (auto const& liquid : liquids())
        for (double ratio = 0.9; ratio < 1.2; ratio += 0.01) {
            double const rho = ratio * liquid.rho0, p = liquid.pressure(rho);
            // An error of the pressure is one of the density times c^2 or more, but for 0.9^6 in tension.
            double const rounding = 4 * eps * parts(liquid, rho) / std::pow(liquid.sound_speed(rho), 2);
            EXPECT_NEAR(liquid.density(p), rho, rounding + 4 * eps * rho) << ratio;
        }
}

TEST(EquationOfState, RisesWithTheSquareOfTheSoundSpeed) {
    for (auto const& liquid : liquids())
        for (double const ratio : {0.8, 0.9, 1.0, 1.1, 1.3}) {
            double const rho = ratio * liquid.rho0, d = 0.05 * liquid.rho0, c = liquid.sound_speed(rho);
            double const sum_of_parts = 2 * (672 + 168 + 32 + 3) * parts(liquid, rho + 4 * d) / (840 * d);
            EXPECT_NEAR(slope(liquid, rho, d), c * c, 4 * eps * sum_of_parts) << ratio;
        }
}

TEST(EquationOfState, HasTheSoundSpeedItIsNamedAfterAtTheReferenceDensity) {
    for (auto const& liquid : liquids()) {
        double const d = 0.05 * liquid.rho0;
        double const sum_of_parts = 2 * (672 + 168 + 32 + 3) * parts(liquid, liquid.rho0 + 4 * d) / (840 * d);
        EXPECT_NEAR(slope(liquid, liquid.rho0, d), liquid.c * liquid.c, 4 * eps * sum_of_parts);
    }
}

TEST(EquationOfState, StoresTheWorkOfItsPressure) {
    for (auto const& liquid : liquids()) {
        EXPECT_EQ(liquid.energy(liquid.rho0), 0);
        for (double const from : {0.9, 1.0, 1.05}) {  // p dV by Simpson's rule, over 0.2 % of the density
            double const a = from * liquid.rho0, b = a + 0.002 * liquid.rho0;
            auto const push = [&](double rho) { return liquid.pressure(rho) / (rho * rho); };
            double const work = (b - a) / 6 * (push(a) + 4 * push((a + b) / 2) + push(b)), c2 = liquid.c * liquid.c;
            EXPECT_NEAR(liquid.energy(b) - liquid.energy(a), work, 1e-8 * std::fabs(work) + 8 * eps * c2) << from;
        }
    }
}

TEST(EquationOfState, OfTaitLosesAllDensityAtItsGreatestTension) {
    EquationOfState const liquid{.kind = Kind::tait, .rho0 = 3, .c = 2, .gamma = 4};  // rho0 c^2/gamma is 3
    EXPECT_EQ(liquid.density(-3), 0);
    EXPECT_EQ(liquid.pressure(0), -3);
}

TEST(EquationOfState, OfTaitHasThePressureOfMonaghanAtTwiceTheDensity) {
    // Monaghan (1994): B ((rho/rho0)^7 - 1) with B = rho0 c^2/7; (2^7 - 1) B at twice the density.
    EquationOfState const water{.kind = Kind::tait, .rho0 = 1000, .c = 10, .gamma = 7};
    EXPECT_NEAR(water.pressure(2000), 127 * 1e5 / 7, 4 * eps * 127 * 1e5 / 7);
}

constexpr double pressure = 3.0, viscosity = 0.5;

template <class T>
T random_tensor() {
    static std::mt19937 engine(1);
    static std::uniform_real_distribution<double> entry(-1, 1);
    T t;
    for (double& c : t.c) c = entry(engine);
    return t;
}

template <class Check>
void in_two_and_three_dimensions(Check const& check) {
    for (int sample = 0; sample < 100; ++sample) {
        check.template operator()<2>();
        check.template operator()<3>();
    }
}

template <int D>
void expect_stress(Matrix<double, D> const& grad_v, Matrix<double, D> const& expected) {
    auto const sigma = Newtonian{viscosity}.stress(pressure, grad_v);
    // No component has parts above the pressure and two viscous ones of D + 1 entries.
    double const rounding = 2 * eps * (pressure + 2 * viscosity * (D + 1) * std::sqrt(norm2(grad_v)));
    for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) EXPECT_NEAR(sigma(a, b), expected(a, b), rounding) << a << b;
}

TEST(Newtonian, StressIsPressureInALiquidAtRest) {
    in_two_and_three_dimensions(
        []<int D>() { expect_stress(Matrix<double, D>{}, -pressure * coronet::identity<double, D>()); });
}

TEST(Newtonian, StressIsPressureInRigidRotation) {
    in_two_and_three_dimensions([]<int D>() {
        auto const a = random_tensor<Matrix<double, D>>();
        expect_stress(a - transpose(a), -pressure * coronet::identity<double, D>());
    });
}

TEST(Newtonian, StressIsPressureInUniformExpansion) {
    in_two_and_three_dimensions([]<int D>() {
        for (double const rate : {-0.7, 0.7})
            expect_stress(rate * coronet::identity<double, D>(), -pressure * coronet::identity<double, D>());
    });
}

TEST(Newtonian, StressOfPureShearIsViscosityTimesItsRate) {
    in_two_and_three_dimensions([]<int D>() {
        for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) {
                if (a == b) continue;
                Matrix<double, D> shear, expected = -pressure * coronet::identity<double, D>();
                shear(a, b) = 0.7;
                expected(a, b) = expected(b, a) = viscosity * 0.7;
                expect_stress(shear, expected);
            }
    });
}

TEST(Newtonian, StressOfStretchingIsTwiceViscosityTimesItsRate) {
    expect_stress<2>({{0.7, 0, 0, -0.7}}, {{-pressure + 2 * viscosity * 0.7, 0, 0, -pressure - 2 * viscosity * 0.7}});
    expect_stress<3>({{0.7, 0, 0, 0, -0.35, 0, 0, 0, -0.35}},
                     {{-pressure + 2 * viscosity * 0.7, 0, 0, 0, -pressure - viscosity * 0.7, 0, 0, 0,
                       -pressure - viscosity * 0.7}});
}

TEST(Newtonian, ViscousStressHasNoTrace) {
    in_two_and_three_dimensions([]<int D>() {
        auto const grad_v = random_tensor<Matrix<double, D>>();
        auto const tau = Newtonian{viscosity}.stress(0.0, grad_v);
        double trace = 0, sum_of_parts = 0;
        for (int k = 0; k < D; ++k) {
            trace += tau(k, k);
            sum_of_parts += 4 * viscosity * std::fabs(grad_v(k, k));
        }
        EXPECT_NEAR(trace, 0, 2 * D * eps * sum_of_parts);
    });
}

TEST(Newtonian, StressTurnsWithTheFlow) {
    // The flow turned by a reflection Q = I - 2 n n^T, of any direction: sigma(Q G Q^T) = Q sigma(G) Q^T.
    in_two_and_three_dimensions([]<int D>() {
        auto const n = random_tensor<coronet::Vector<double, D>>();
        auto const Q = coronet::identity<double, D>() - (2 / norm2(n)) * outer(n, n);
        auto const turned = [&](auto const& a) {
            return coronet::product<double, D>(coronet::product<double, D>(Q, a), Q);
        };
        auto const grad_v = random_tensor<Matrix<double, D>>();
        auto const sigma = Newtonian{viscosity}.stress(pressure, grad_v);
        auto const sigma_of_turned = Newtonian{viscosity}.stress(pressure, turned(grad_v));
        // Each of the two products has D parts per entry, each of Q's entries some rounding of n; |Q| is
        // D^(1/2).
        double const size = std::sqrt(D) * pressure + 2 * viscosity * 3 * std::sqrt(norm2(grad_v));
        for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) EXPECT_NEAR(sigma_of_turned(a, b), turned(sigma)(a, b), 16 * D * eps * size);
    });
}

TEST(Newtonian, ViscosityOnlyTakesEnergy) {
    in_two_and_three_dimensions([]<int D>() {
        auto const grad_v = random_tensor<Matrix<double, D>>();
        auto const tau = Newtonian{viscosity}.stress(0.0, grad_v);
        double power = 0;
        for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) power += tau(a, b) * grad_v(a, b);
        EXPECT_GT(power, 0);
    });
}

}  // namespace
