// SPDX-License-Identifier: BSD-3-Clause

// What must change nothing: the number of threads, a moving frame, a turned frame, the margin of the neighbour lists.

#include <gtest/gtest.h>

#include "coronet/cases/shapes.hpp"
#include "coronet/core/parallel.hpp"
#include "coronet/schemes/weakly_compressible.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

template <int D>
std::vector<double> after_steps(Case const& c, int steps) {
    auto const scheme = make_scheme<D>(c);
    double time = 0;
    for (int n = 0; n < steps; ++n) {
        scheme->begin_step(time);
        double const step = c.time.step > 0 ? c.time.step : scheme->time_limit().step;
        scheme->advance(time, step);
        time += step;
    }
    auto const& particles = scheme->particles();
    std::vector<double> state(particles.owned() * (2 * D + 1));
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        double* const row = state.data() + static_cast<std::size_t>(particles.id[i]) * (2 * D + 1);
        for (int k = 0; k < D; ++k) {
            row[k] = particles.template get<Position>(k)[i];
            row[D + k] = particles.template get<Velocity>(k)[i];
        }
        row[2 * D] = particles.template get<Density>()[i];
    }
    return state;
}

template <int D>
void expect_same_bits_for_any_threads(std::string const& gradient, std::string const& precision) {
    auto c = liquid_case<D>({.gradient = gradient, .step = 2e-3, .more = "[output]\nframes = false\n"});
    c.method.precision = precision;
    set_threads(1);
    auto const one = after_steps<D>(c, 30);
    set_threads(2);
    auto const two = after_steps<D>(c, 30);
    set_threads(3);
    auto const three = after_steps<D>(c, 30);
    set_threads(0);
    EXPECT_EQ(one, two) << gradient;
    EXPECT_EQ(one, three) << gradient;
}

}  // namespace

TEST(Threads, ChangeNoBitOfTheResult) {
    for (std::string const gradient : {"sph", "cph", "fpm"})
        for (std::string const precision : {"double", "mixed"}) {
            expect_same_bits_for_any_threads<2>(gradient, precision);
            expect_same_bits_for_any_threads<3>(gradient, precision);
        }
}

TEST(MovingFrame, ChangesTheMotionByItsVelocityOnly) {
    LiquidOptions const still{.step = 1e-3};
    LiquidOptions moving = still;
    moving.velocity_2d = "'sin(2*y) - x*y + 101', 'cos(3*x) + 0.5*x - 50'";
    auto const a = after_steps<2>(liquid_case<2>(still), 50), b = after_steps<2>(liquid_case<2>(moving), 50);
    for (std::size_t k = 0; k < a.size(); k += 5) {
        // Velocities of 100 m/s are known to 1e-14 m/s, accelerations amplify their differences by 1/spacing.
        EXPECT_NEAR(b[k] - a[k], 100 * 0.05, 1e-9);
        EXPECT_NEAR(b[k + 1] - a[k + 1], -50 * 0.05, 1e-9);
        EXPECT_NEAR(b[k + 2] - a[k + 2], 100, 1e-8);
        EXPECT_NEAR(b[k + 4], a[k + 4], 1e-9);
    }
}

TEST(TurnedFrame, TurnsTheAccelerations) {
    // The same particles, turned by 40 degrees with their velocities, made by hand since jitter does not turn.
    auto const rates = [](double degrees) {
        auto const scheme = liquid<2>();
        Particles<2> particles(scheme->particles().owned());
        particles.allocate(Fields<Position, Velocity, Density, Mass>{});
        auto const from = scheme->particles().view(), to = particles.view();
        for (std::size_t i = 0; i < particles.size(); ++i) {
            auto const id = static_cast<std::size_t>(scheme->particles().id[i]);
            to.set<Position>(id, turned(from.get<Position>(i), degrees));
            to.set<Velocity>(id, turned(from.get<Velocity>(i), degrees));
            to.set<Density>(id, from.get<Density>(i));
            to.set<Mass>(id, from.get<Mass>(i));
        }
        WeaklyCompressible<2>::Settings s;
        s.kernel = make_kernel("quintic-spline", 2, 0.3);
        s.skin = 0.02;
        s.liquid.rheology.viscosity = 0.5;
        s.equation_of_state = {EquationOfState::Kind::linear, 1, 20, 7};
        WeaklyCompressible<2> turned_scheme(s, std::move(particles));
        turned_scheme.evaluate(0);
        std::vector<Vector<double, 2>> dv(turned_scheme.particles().owned());
        for (std::size_t i = 0; i < dv.size(); ++i)
            dv[static_cast<std::size_t>(turned_scheme.particles().id[i])] =
                turned(turned_scheme.particles().view().get<Acceleration>(i), -degrees);
        return dv;
    };
    auto const straight = rates(0), oblique = rates(40);
    for (std::size_t i = 0; i < straight.size(); ++i)
        for (int k = 0; k < 2; ++k) EXPECT_NEAR(straight[i][k], oblique[i][k], 1e-9 * (1 + std::fabs(straight[i][k])));
}

TEST(Skin, ChangesNothingButRoundOff) {
    auto const state = [](double skin) {
        auto c = liquid_case<2>({.step = 1e-3});
        c.method.skin = skin;
        return after_steps<2>(c, 50);
    };
    auto const narrow = state(0.05), wide = state(1);
    for (std::size_t k = 0; k < narrow.size(); ++k) EXPECT_NEAR(narrow[k], wide[k], 1e-10);
}

TEST(FreeFall, IsExactWithTheMeanVelocity) {
    auto c = liquid_case<2>({.more = "[output]\nframes = false\n"});
    c.fluid.gravity = {0, -9.81};
    auto const scheme = make_scheme<2>(c);
    auto const start = totals(scheme->particles());
    double const step = 1e-3;
    for (int n = 0; n < 50; ++n) {
        scheme->begin_step(n * step);
        scheme->advance(n * step, step);
    }
    auto const now = totals(scheme->particles());
    double const t = 50 * step;
    EXPECT_NEAR(now.centre()[0], start.centre()[0] + start.momentum[0] / start.mass * t, 1e-13);
    EXPECT_NEAR(now.centre()[1], start.centre()[1] + start.momentum[1] / start.mass * t - 9.81 * t * t / 2, 1e-13);
}

TEST(BodyForce, MayDependOnPlaceAndTime) {
    auto c = liquid_case<2>({});
    auto const plain = make_scheme<2>(c);
    c.fluid.body_force = {"3*x + 100*t", "-y^2"};
    auto const forced = make_scheme<2>(c);
    plain->begin_step(0.25);
    forced->begin_step(0.25);
    auto const a = plain->particles().view(), b = forced->particles().view();
    for (std::size_t i = 0; i < plain->particles().owned(); ++i) {
        auto const x = a.get<Position>(i);
        auto const difference = b.get<Acceleration>(i) - a.get<Acceleration>(i);
        EXPECT_NEAR(difference[0], 3 * x[0] + 25, 1e-10);
        EXPECT_NEAR(difference[1], -x[1] * x[1], 1e-10);
    }
}

TEST(PredictorCorrector, IsOfSecondOrder) {
    auto const state = [](double step) {
        return after_steps<2>(liquid_case<2>({.viscosity = 0, .step = step}),
                              static_cast<int>(std::lround(0.008 / step)));
    };
    auto const coarse = state(1e-3), middle = state(5e-4), fine = state(2.5e-4);
    double first = 0, second = 0;
    for (std::size_t k = 0; k < coarse.size(); ++k) {
        first = std::max(first, std::fabs(coarse[k] - middle[k]));
        second = std::max(second, std::fabs(middle[k] - fine[k]));
    }
    EXPECT_NEAR(std::log2(first / second), 2, 0.2);
}

}  // namespace coronet
