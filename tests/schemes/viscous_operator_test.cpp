// SPDX-License-Identifier: BSD-3-Clause

// What holds of the viscous operator on any arrangement of particles, and of a step through it.

#include <functional>

#include <gtest/gtest.h>

#include "coronet/schemes/viscous_step.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double support = 2.6;

GeneralisedNewtonian thinning() {
    return {{.model = Rheology::Model::bingham, .yield_stress = 3, .plastic_viscosity = 0.1, .regularisation = 100}};
}

template <int D>
Kernel kernel(Body<D> const& body) {
    return make_kernel("wendland-c2", D, support * body.dx);
}

/// With a viscosity that differs from particle to particle.
template <int D>
ViscousOperator<D> made(Body<D> const& b) {
    ViscousOperator<D> K(kernel(b));
    K.set_up(b.particles, b.neighbours);
    K.set_viscosity(thinning(), random_numbers(D * b.particles.size(), 9));
    return K;
}

template <int D>
void set_velocity(Particles<D>& particles, std::function<Vector<double, D>(Vector<double, D> const&)> const& v) {
    particles.template allocate<Acceleration>();
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        view.template set<Velocity>(i, v(view.template get<Position>(i)));
        view.template set<Acceleration>(i, {});
    }
}

template <int D>
double energy(Particles<D> const& particles) {
    auto const view = particles.view();
    return sum_over(particles.size(), 0.0, [&](std::size_t i) { return norm2(view.template get<Velocity>(i)) / 2; });
}

/// act(2, spacings per radius) and act(3, ...).
template <class Act>
void in_2d_and_3d(Act const& act) {
    act(std::integral_constant<int, 2>{}, 12);
    act(std::integral_constant<int, 3>{}, 5);
}

}  // namespace

TEST(ViscousOperator, IsSymmetricAndOnlyTakesEnergy) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int spacings) {
        for (double const jitter : {0.0, 0.3}) {
            auto const b = body<D>(spacings, jitter, support);
            auto K = made(*b);
            std::size_t const n = D * b->particles.size();
            auto const u = random_numbers(n, 1), w = random_numbers(n, 2);
            std::vector<double> Ku(n), Kw(n);
            K.apply(u, Ku);
            K.apply(w, Kw);
            double const uKu = inner_product(u, Ku);
            EXPECT_GT(uKu, 0);
            EXPECT_NEAR(inner_product(w, Ku), inner_product(u, Kw), 1e-13 * uKu);
        }
    });
}

TEST(ViscousOperator, KnowsItsDiagonal) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int spacings) {
        auto const b = body<D>(spacings, 0.3, support);
        auto K = made(*b);
        std::size_t const n = D * b->particles.size();
        std::vector<double> diagonal(n), unit(n), column(n);
        K.diagonal(diagonal);
        for (std::size_t a = 0; a < n; a += n / 7) {
            unit[a] = 1;
            K.apply(unit, column);
            unit[a] = 0;
            EXPECT_NEAR(diagonal[a], column[a], 1e-13 * column[a]);
        }
    });
}

TEST(ViscousOperator, KeepsMomentumAndAngularMomentum) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int spacings) {
        auto const b = body<D>(spacings, 0.2, support);
        auto K = made(*b);
        ASSERT_EQ(K.singular_matrices(), 0);
        std::size_t const n = b->particles.size();
        std::vector<double> force(D * n);
        K.apply(random_numbers(D * n, 1), force);
        Vector<double, D> sum;
        double size = 0, turning = 0;
        for (std::size_t i = 0; i < n; ++i) {
            auto const x = b->particles.view().template get<Position>(i);
            for (int k = 0; k < D; ++k) {
                sum[k] += force[D * i + static_cast<std::size_t>(k)];
                size += std::fabs(force[D * i + static_cast<std::size_t>(k)]);
            }
            turning += x[0] * force[D * i + 1] - x[1] * force[D * i];
        }
        EXPECT_LT(std::sqrt(norm2(sum)), 1e-14 * size);
        EXPECT_LT(std::fabs(turning), 1e-14 * size);
    });
}

TEST(ViscousStep, LeavesARigidMotionAlone) {
    in_2d_and_3d([]<int D>(std::integral_constant<int, D>, int spacings) {
        auto const b = body<D>(spacings, 0.2, support);
        auto const rigid = [](Vector<double, D> const& x) {
            Vector<double, D> v{{7 - 3 * x[1], -2 + 3 * x[0]}};
            return v;
        };
        set_velocity<D>(b->particles, rigid);
        double const h = support * b->dx / 3, step = 100 * h * h / 8;  // 100 times the explicit limit at nu = 1
        ViscousStep<D> viscous(kernel(*b), {{.viscosity = 1000}}, {1e-10, 1000});
        EXPECT_TRUE(viscous.advance(b->particles, b->neighbours, step).converged);
        auto const view = b->particles.view();
        for (std::size_t i = 0; i < b->particles.size(); ++i)
            EXPECT_LT(norm2(view.template get<Velocity>(i) - rigid(view.template get<Position>(i))), 1e-20);
    });
}

TEST(ViscousStep, KeepsMomentumAndAngularMomentumHoweverRoughlyItIsSolved) {
    auto const b = body<2>(12, 0.2, support);
    set_smooth_velocity(b->particles);
    b->particles.allocate<Acceleration>();
    auto const view = b->particles.view();
    auto const total = [&] {
        Vector<double, 3> sum;
        for (std::size_t i = 0; i < b->particles.size(); ++i) {
            auto const x = view.get<Position>(i), v = view.get<Velocity>(i);
            sum += Vector<double, 3>{{v[0], v[1], x[0] * v[1] - x[1] * v[0]}};
        }
        return sum;
    };
    auto const before = total();
    double const energy_before = energy(b->particles);
    ViscousStep<2> viscous(kernel(*b), {{.viscosity = 1000}}, {1e-2, 1000});
    EXPECT_TRUE(viscous.advance(b->particles, b->neighbours, 0.01).converged);
    EXPECT_LT(energy(b->particles), 0.999 * energy_before);
    // Some 400 particles of speeds up to 7, over them round-off adds up.
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(total()[k], before[k], 1e-11);
}

TEST(ViscousStep, OnlyTakesEnergyAtAnyLengthOfStep) {
    for (double const step : {1e-3, 1.0, 1e3}) {
        auto const b = body<2>(7, 0.3, support);
        b->particles.allocate<Acceleration>();
        auto const v = random_numbers(2 * b->particles.size(), 4);
        auto const view = b->particles.view();
        for (std::size_t i = 0; i < b->particles.size(); ++i) view.set<Velocity>(i, {{v[2 * i], v[2 * i + 1]}});
        ViscousStep<2> viscous(kernel(*b), thinning(), {1e-6, 3000});
        double before = energy(b->particles);
        for (int k = 0; k < 2; ++k) {
            EXPECT_TRUE(viscous.advance(b->particles, b->neighbours, step).converged);
            double const after = energy(b->particles);
            EXPECT_LT(after, (1 + 1e-6) * before) << step;
            before = after;
        }
    }
}

TEST(ViscousStep, LeavesAForceAloneThatTheStressBalances) {
    auto const b = body<2>(12, 0.2, support);
    set_velocity<2>(b->particles, [](auto const& x) { return Vector<double, 2>{{std::sin(3 * x[1]), x[0] * x[1]}}; });
    auto const view = b->particles.view();
    std::size_t const n = b->particles.size();
    GeneralisedNewtonian const liquid{{.viscosity = 1000}};
    std::vector<double> v(2 * n), Kv(2 * n);
    for (std::size_t a = 0; a < 2 * n; ++a) v[a] = view.at<Velocity>(static_cast<int>(a % 2))[a / 2];
    ViscousOperator<2> K(kernel(*b));
    K.set_up(b->particles, b->neighbours);
    K.set_viscosity(liquid, v);
    K.apply(v, Kv);
    for (std::size_t a = 0; a < 2 * n; ++a)
        view.at<Acceleration>(static_cast<int>(a % 2))[a / 2] = Kv[a] / view.at<Mass>()[a / 2];
    ViscousStep<2> viscous(kernel(*b), liquid, {1e-10, 3000});
    EXPECT_TRUE(viscous.advance(b->particles, b->neighbours, 1).converged);  // 600 times the explicit limit
    for (std::size_t a = 0; a < 2 * n; ++a) EXPECT_NEAR(view.at<Velocity>(static_cast<int>(a % 2))[a / 2], v[a], 1e-6);
}

TEST(ViscousStep, GivesTheSameBitsForAnyNumberOfThreads) {
    auto const speeds = [](int count) {
        set_threads(count);
        auto const b = body<2>(25, 0.2, support);
        set_smooth_velocity(b->particles);
        b->particles.allocate<Acceleration>();
        ViscousStep<2> viscous(kernel(*b), thinning(), {1e-6, 1000});
        viscous.advance(b->particles, b->neighbours, 1);
        auto const v = b->particles.get<Velocity>(0);
        return std::vector<double>(v.begin(), v.end());
    };
    EXPECT_EQ(speeds(1), speeds(2));
    set_threads(0);
}

TEST(ViscousStep, SaysThatItHasNotConverged) {
    auto const b = body<2>(12, 0.2, support);
    set_smooth_velocity(b->particles);
    b->particles.allocate<Acceleration>();
    ViscousStep<2> viscous(kernel(*b), {{.viscosity = 1000}}, {1e-8, 5});
    auto const solved = viscous.advance(b->particles, b->neighbours, 1);
    EXPECT_FALSE(solved.converged);
    EXPECT_GT(solved.residual, 1e-8);
}

}  // namespace coronet
