// SPDX-License-Identifier: BSD-3-Clause

// What holds of every pressure operator, and of the consistent one's projection.

#include <gtest/gtest.h>

#include "coronet/schemes/consistent_pressure.hpp"
#include "coronet/schemes/projection.hpp"
#include "coronet/schemes/thesis_pressure.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double support = 2.6;

template <int D>
Kernel kernel(Body<D> const& body) {
    return make_kernel("wendland-c2", D, support * body.dx);
}

template <int D>
std::unique_ptr<PressureOperator<D>> consistent(Body<D> const& body, GradientKind kind, double compact_share = 0) {
    return std::make_unique<ConsistentPressure<D>>(kernel(body), kind, compact_share);
}
template <int D>
std::unique_ptr<ThesisPressure<D>> thesis(Body<D> const& body, SurfacePressure surface, bool lattice_diagonal = false) {
    auto made = std::make_unique<ThesisPressure<D>>(
        kernel(body), typename ThesisPressure<D>::Options{surface, body.dx, lattice_diagonal});
    made->set_normals(body.normals);
    return made;
}

template <int D>
std::vector<std::unique_ptr<PressureOperator<D>>> every_operator(Body<D> const& body) {
    std::vector<std::unique_ptr<PressureOperator<D>>> all;
    for (auto kind : {GradientKind::plain, GradientKind::corrected})
        for (double const compact_share : {0.0, 0.3}) all.push_back(consistent(body, kind, compact_share));
    for (auto surface : {SurfacePressure::free, SurfacePressure::zero, SurfacePressure::mirrored})
        for (bool lattice_diagonal : {false, true}) all.push_back(thesis(body, surface, lattice_diagonal));
    return all;
}

template <int D>
void expect_symmetry_and_the_right_diagonal(int spacings) {
    auto const b = body<D>(spacings, 0.3, support);
    std::size_t const n = b->particles.size();
    for (auto const& A : every_operator(*b)) {
        A->set_up(b->particles, b->neighbours);
        auto const p = random_numbers(n, 1), q = random_numbers(n, 2);
        std::vector<double> Ap(n), Aq(n);
        A->apply(p, Ap);
        A->apply(q, Aq);
        double const pAp = inner_product(p, Ap);
        EXPECT_GT(pAp, 0);
        EXPECT_NEAR(inner_product(q, Ap), inner_product(p, Aq), 1e-14 * pAp);
        for (std::size_t i = 0; i < n; i += n / 7) {
            std::vector<double> one(n, 0.0), row(n);
            one[i] = 1;
            A->apply(one, row);
            EXPECT_NEAR(row[i], A->diagonal()[i], 1e-13 * row[i]);
        }
    }
}

template <int D>
void expect_no_divergence_left(int spacings, double jitter) {
    auto const b = body<D>(spacings, jitter, support);
    for (auto kind : {GradientKind::plain, GradientKind::corrected}) {
        set_smooth_velocity(b->particles);
        std::size_t const n = b->particles.size();
        double const dt = 1e-3, tolerance = 1e-7;
        b->particles.template allocate<Pressure>();
        std::fill_n(b->particles.template get<Pressure>().data(), n, 0.0);
        Projection<D> projection(consistent(*b, kind), Preconditioning::jacobi, b->dx, {tolerance, 3000});
        std::vector<double> before(n), after(n);
        projection.pressure().set_up(b->particles, b->neighbours);
        projection.pressure().source(dt, before);
        EXPECT_TRUE(projection.project(b->particles, b->neighbours, dt).converged);
        projection.pressure().source(dt, after);
        EXPECT_LT(std::sqrt(inner_product(after, after)), 1.01 * tolerance * std::sqrt(inner_product(before, before)));
    }
}

}  // namespace

TEST(PressureOperator, IsSymmetricWithTheDiagonalItSays) {
    expect_symmetry_and_the_right_diagonal<2>(12);
    expect_symmetry_and_the_right_diagonal<3>(5);
}

TEST(PressureOperator, MovesNothingByAConstantInside) {
    // (A 1)_i is the divergence of the force of a constant pressure; on a lattice, nothing two supports from the
    // surface.
    auto const b = body<2>(12, 0, support);
    std::size_t const n = b->particles.size();
    for (auto const& A : every_operator(*b)) {
        A->set_up(b->particles, b->neighbours);
        std::vector<double> A1(n);
        A->apply(std::vector<double>(n, 1.0), A1);
        for (std::size_t i = 0; i < n; ++i) {
            double const r = std::sqrt(norm2(b->particles.view().get<Position>(i)));
            if (r < 1 - 3 * support * b->dx) {
                EXPECT_LT(std::fabs(A1[i]), 1e-13 * A->diagonal()[i]);
            }
        }
    }
}

TEST(ConsistentPressure, ForcesKeepMomentumAndAngularMomentum) {
    auto const check = []<int D>(std::integral_constant<int, D>, int spacings) {
        auto const b = body<D>(spacings, 0.2, support);
        std::size_t const n = b->particles.size();
        auto const p = random_numbers(n, 3);
        for (auto kind : {GradientKind::plain, GradientKind::corrected}) {
            auto const A = consistent(*b, kind);
            A->set_up(b->particles, b->neighbours);
            A->accelerate(p);
            auto const view = b->particles.view();
            Vector<double, D> momentum;
            double turning = 0, size = 0;
            for (std::size_t i = 0; i < n; ++i) {
                auto const dv = view.template get<Acceleration>(i), x = view.template get<Position>(i);
                momentum += dv;
                turning += x[0] * dv[1] - x[1] * dv[0];
                size += std::sqrt(norm2(dv));
            }
            EXPECT_LT(std::sqrt(norm2(momentum)), 1e-14 * size);
            EXPECT_LT(std::fabs(turning), 1e-14 * size);
        }
    };
    check(std::integral_constant<int, 2>{}, 12);
    check(std::integral_constant<int, 3>{}, 5);
}

TEST(ConsistentPressure, LeavesNoDivergence) {
    for (double const jitter : {0.0, 0.1, 0.3}) expect_no_divergence_left<2>(12, jitter);
    for (double const jitter : {0.1, 0.3}) expect_no_divergence_left<3>(5, jitter);
}

TEST(ConsistentPressure, TakesTheEnergyOfWhatItTakesAway) {
    // Orthogonal: |v*|^2 = |v|^2 + |dt dv|^2 in the masses.
    auto const b = body<2>(12, 0.3, support);
    set_smooth_velocity(b->particles);
    auto const view = b->particles.view();
    auto const energy = [&](auto const& v) {
        return sum_over(b->particles.size(), 0.0, [&](std::size_t i) { return norm2(v(i)); });
    };
    auto const velocity = [&](std::size_t i) { return view.get<Velocity>(i); };
    double const dt = 1e-3, before = energy(velocity);
    Projection<2> projection(consistent(*b, GradientKind::corrected), Preconditioning::jacobi, b->dx, {1e-10, 3000});
    ASSERT_TRUE(projection.project(b->particles, b->neighbours, dt).converged);
    auto const dv = b->particles.view();
    double const taken = energy([&](std::size_t i) { return dt * dv.get<Acceleration>(i); });
    double const left = energy([&](std::size_t i) { return dv.get<Velocity>(i); });
    EXPECT_GT(taken, 1e-3 * before);
    EXPECT_NEAR(before, left + taken, 1e-8 * before);
}

TEST(ConsistentPressure, LeavesARigidMotionAlone) {
    auto const b = body<2>(12, 0.3, support);
    auto const view = b->particles.view();
    for (std::size_t i = 0; i < b->particles.size(); ++i) {
        auto const x = view.get<Position>(i);
        view.set<Velocity>(i, {{7 - 3 * x[1], -2 + 3 * x[0]}});
    }
    auto const A = consistent(*b, GradientKind::corrected);
    A->set_up(b->particles, b->neighbours);
    std::vector<double> source(b->particles.size());
    A->source(1, source);
    for (double const s : source) EXPECT_NEAR(s / (b->dx * b->dx), 0, 1e-12 / b->dx);
}

TEST(ConsistentPressure, OnALatticeComesCloserToThePressureAsTheSpacingFalls) {
    // v = dt/rho grad p with p = 0 at the radius that the particles' area has: the pressure is found, the velocity
    // taken.
    auto const error = [](int spacings) {
        auto const b = body<2>(spacings, 0, support);
        auto const view = b->particles.view();
        std::size_t const n = b->particles.size();
        double const R2 = static_cast<double>(n) * b->dx * b->dx / M_PI, dt = 1e-3;
        auto const exact = [&](Vector<double, 2> const& x) { return 1000 * (R2 - norm2(x)) * (1 + x[0] / 2); };
        for (std::size_t i = 0; i < n; ++i) {
            auto const x = view.get<Position>(i);
            auto slope = (-2 * (1 + x[0] / 2)) * x;
            slope[0] += (R2 - norm2(x)) / 2;
            view.set<Velocity>(i, dt * slope);
        }
        Projection<2> projection(consistent(*b, GradientKind::corrected), Preconditioning::jacobi, b->dx, {1e-4, 3000});
        EXPECT_TRUE(projection.project(b->particles, b->neighbours, dt).converged);
        double difference = 0, size = 0;
        for (std::size_t i = 0; i < n; ++i) {
            double const p = exact(view.get<Position>(i));
            difference += std::pow(b->particles.get<Pressure>()[i] - p, 2);
            size += p * p;
        }
        return std::sqrt(difference / size);
    };
    double const coarse = error(10), fine = error(40);
    EXPECT_LT(fine, 0.03);
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 0.4) << coarse << " " << fine;
}

TEST(ConsistentPressure, WithAShareTheMultigridTakesAsManyIterationsForAnyNumberOfParticles) {
    auto const iterations = [](int spacings, Preconditioning preconditioning) {
        auto const b = body<2>(spacings, 0.1, support);
        set_smooth_velocity(b->particles);
        Projection<2> projection(consistent(*b, GradientKind::corrected, 0.05), preconditioning, b->dx, {1e-8, 1000});
        auto const solved = projection.project(b->particles, b->neighbours, 1e-3);
        EXPECT_TRUE(solved.converged);
        return solved.iterations;
    };
    EXPECT_LT(iterations(64, Preconditioning::multigrid), iterations(16, Preconditioning::multigrid) + 5);
    EXPECT_LT(iterations(64, Preconditioning::multigrid), 40);
    EXPECT_GT(iterations(64, Preconditioning::jacobi), 2 * iterations(16, Preconditioning::jacobi));
}

TEST(Projection, GivesTheSameBitsForAnyNumberOfThreads) {
    auto const pressures = [](int count, Preconditioning preconditioning) {
        set_threads(count);
        auto const b = body<2>(25, 0.2, support);
        set_smooth_velocity(b->particles);
        Projection<2> projection(thesis(*b, SurfacePressure::mirrored), preconditioning, b->dx, {1e-8, 3000});
        EXPECT_TRUE(projection.project(b->particles, b->neighbours, 1e-3).converged);
        Projection<2> again(consistent(*b, GradientKind::corrected), preconditioning, b->dx, {1e-2, 3000});
        EXPECT_TRUE(again.project(b->particles, b->neighbours, 1e-3).converged);
        auto const p = b->particles.get<Pressure>();
        return std::vector<double>(p.begin(), p.end());
    };
    for (auto preconditioning : {Preconditioning::jacobi, Preconditioning::multigrid})
        EXPECT_EQ(pressures(1, preconditioning), pressures(2, preconditioning));
    set_threads(0);
}

TEST(Projection, StartsFromThePressureOfBefore) {
    auto const b = body<2>(12, 0.2, support);
    auto const iterations = [&] {
        set_smooth_velocity(b->particles);
        Projection<2> projection(thesis(*b, SurfacePressure::zero), Preconditioning::multigrid, b->dx, {1e-6, 1000});
        return projection.project(b->particles, b->neighbours, 1e-3).iterations;
    };
    EXPECT_GT(iterations(), 3);
    EXPECT_EQ(iterations(), 0);
}

TEST(Projection, SaysThatItHasNotConverged) {
    auto const b = body<2>(12, 0.2, support);
    set_smooth_velocity(b->particles);
    Projection<2> projection(consistent(*b, GradientKind::plain), Preconditioning::jacobi, b->dx, {1e-8, 5});
    auto const solved = projection.project(b->particles, b->neighbours, 1e-3);
    EXPECT_FALSE(solved.converged);
    EXPECT_EQ(solved.iterations, 5);
    EXPECT_GT(solved.residual, 1e-8);
}

}  // namespace coronet
