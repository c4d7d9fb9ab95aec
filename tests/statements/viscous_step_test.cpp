// SPDX-License-Identifier: BSD-3-Clause

// The implicit viscous step beside the explicit one, on a disc of radius 1 m and viscosity nu = 0.001 m^2/s whose rings
// turn at different speeds: v_theta = J_1(k r) with J_2(k) = 0 has no stress at r = 1 and decays as exp(-nu k^2 t).

#include <functional>

#include <gtest/gtest.h>

#include "coronet/schemes/incompressible.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double k = 5.135622301840683, nu = 1e-3, decay_time = 1 / (k * k * nu), support = 3.5;
double const rms = std::fabs(j1(k));  // of J_1(k r) over the disc, whose mean square is J_1(k)^2 - J_0(k) J_2(k)

void set_azimuthal(Particles<2>& particles, std::function<double(double)> const& speed_over_r) {
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto const x = view.get<Position>(i);
        view.set<Velocity>(i, speed_over_r(std::sqrt(norm2(x))) * Vector<double, 2>{{-x[1], x[0]}});
    }
}

double explicit_limit(double dx) { return std::pow(support * dx / 3, 2) / (8 * nu); }

/// Velocities after 1.5 decay times in equal steps of about `limits` times the explicit limit.
std::vector<Vector<double, 2>> decayed(int spacings, double speed, double limits,
                                       Incompressible<2>::Viscous viscous_step) {
    auto const b = body<2>(spacings, 0.1, support);
    set_azimuthal(b->particles, [&](double r) { return speed * j1(k * r) / r; });
    Incompressible<2>::Settings s;
    s.kernel = make_kernel("wendland-c2", 2, support * b->dx);
    s.pressure_kernel = make_kernel("wendland-c2", 2, 2.1 * b->dx);
    s.liquid.rheology.viscosity = 1000 * nu;
    s.viscous_step = viscous_step;
    s.solve = {1e-4, 2000};
    s.surface.spacing = b->dx;
    Incompressible<2> scheme(s, std::move(b->particles));
    double const end = 1.5 * decay_time;
    int const steps = static_cast<int>(std::floor(end / (limits * explicit_limit(b->dx))));
    EXPECT_GE(end / steps, limits * explicit_limit(b->dx));
    for (int n = 0; n < steps; ++n) {
        scheme.begin_step(n * end / steps);
        scheme.advance(n * end / steps, end / steps);
    }
    std::vector<Vector<double, 2>> v(scheme.particles().size());  // in the order of the start
    for (std::size_t i = 0; i < v.size(); ++i)
        v[static_cast<std::size_t>(scheme.particles().id[i])] = scheme.particles().view().get<Velocity>(i);
    return v;
}

double size(std::vector<Vector<double, 2>> const& v) {
    return std::sqrt(sum_over(v.size(), 0.0, [&](std::size_t i) { return norm2(v[i]); }));
}

}  // namespace

TEST(ImplicitViscousStep, AtAHundredTimesTheExplicitLimitFollowsTheExplicitOneThroughADecayingShearLayer) {
    // On particles that stand still: forward Euler at its limit, and two implicit steps.
    auto const b = body<2>(30, 0.1, support);
    set_azimuthal(b->particles, [&](double r) { return j1(k * r) / r; });
    b->particles.allocate<Acceleration>();
    auto const view = b->particles.view();
    std::size_t const n = b->particles.size();
    GeneralisedNewtonian const liquid{{.viscosity = 1000 * nu}};
    Kernel const kernel = make_kernel("wendland-c2", 2, support * b->dx);
    std::vector<double> start(2 * n), Kv(2 * n);
    for (std::size_t a = 0; a < 2 * n; ++a) start[a] = view.at<Velocity>(static_cast<int>(a % 2))[a / 2];

    ViscousOperator<2> K(kernel);
    K.set_up(b->particles, b->neighbours);
    K.set_viscosity(liquid, start);
    auto v = start;
    double const limit = explicit_limit(b->dx), end = 200 * limit;
    for (int step = 0; step < 200; ++step) {
        K.apply(v, Kv);
        for (std::size_t a = 0; a < 2 * n; ++a) v[a] -= limit / view.at<Mass>()[a / 2] * Kv[a];
    }
    ViscousStep<2> viscous(kernel, liquid, {1e-6, 1000});
    for (int step = 0; step < 2; ++step) EXPECT_TRUE(viscous.advance(b->particles, b->neighbours, end / 2).converged);
    double difference2 = 0;
    for (std::size_t a = 0; a < 2 * n; ++a)
        difference2 += std::pow(view.at<Velocity>(static_cast<int>(a % 2))[a / 2] - v[a], 2);
    double const start2 = inner_product(start, start), left2 = inner_product(v, v);
    EXPECT_LT(left2, 0.2 * start2);
    EXPECT_LT(difference2, 0.01 * 0.01 * left2);
}

TEST(ImplicitViscousStep, AtAHundredTimesTheExplicitLimitFollowsTheExplicitOneWhereTheLiquidMoves) {
    // The rings pass each other by a spacing in all, the fastest by 0.3 spacings in the first of three steps. Of the
    // speeds at the start, of which a quarter is left; three steps have 0.4 % from the time stepping alone, the rest is
    // from the pressure, which follows the viscous step instead of acting with it. Its share falls as the root of the
    // step.
    using enum Incompressible<2>::Viscous;
    double const speed = 9e-4;
    auto const fine = decayed(30, speed, 1, explicit_step);
    double const start = speed * rms * std::sqrt(static_cast<double>(fine.size()));
    auto const error = [&](double limits) {
        auto difference = decayed(30, speed, limits, implicit_step);
        for (std::size_t i = 0; i < fine.size(); ++i) difference[i] = difference[i] - fine[i];
        return size(difference) / start;
    };
    EXPECT_LT(size(fine), 0.25 * start);
    double const hundred = error(100);
    EXPECT_LT(hundred, 0.01);
    EXPECT_LT(error(50), 0.8 * hundred);
}

TEST(ImplicitViscousStep, BringsABinghamPlugToRestInAFewSteps) {
    // Stresses stay far below the yield stress: the liquid is as thick as its regularisation says, M tau_y = 100 Pa s,
    // and a step of 2.6 decay times, 85 times the explicit limit, takes nearly all. What is left is in motions of the
    // outermost particles against each other that the gradient hardly sees. With the plastic viscosity alone nothing
    // slows down.
    auto const left = [](double yield_stress) {
        auto const b = body<2>(12, 0.1, support);
        set_azimuthal(b->particles, [](double r) { return 1e-4 * j1(k * r) / r; });
        b->particles.allocate<Acceleration>();
        auto const view = b->particles.view();
        auto const speed2 = [&] {
            return sum_over(b->particles.size(), 0.0, [&](std::size_t i) { return norm2(view.get<Velocity>(i)); });
        };
        double const before = speed2();
        ViscousStep<2> viscous(make_kernel("wendland-c2", 2, support * b->dx),
                               {{.model = Rheology::Model::bingham,
                                 .yield_stress = yield_stress,
                                 .plastic_viscosity = 0.1,
                                 .regularisation = 100}},
                               {1e-6, 1000});
        for (int step = 0; step < 4; ++step) EXPECT_TRUE(viscous.advance(b->particles, b->neighbours, 1).converged);
        return std::sqrt(speed2() / before);
    };
    EXPECT_LT(left(1), 0.06);
    EXPECT_GT(left(0), 0.95);
}

}  // namespace coronet
