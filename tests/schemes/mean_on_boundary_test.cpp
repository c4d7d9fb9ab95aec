// SPDX-License-Identifier: BSD-3-Clause

// What a pressure operator keeps, and what it gains, when the mean of its pressure acts on the boundary.

#include "coronet/schemes/mean_on_boundary.hpp"

#include <gtest/gtest.h>

#include "coronet/schemes/consistent_pressure.hpp"
#include "coronet/schemes/projection.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double support = 3.5;

Boundary<2> boundary_of(Body<2>& body) {
    return find_boundary(body.particles, body.neighbours, 1.2 * body.dx, body.dx, body.dx * body.dx);
}

std::unique_ptr<MeanOnBoundary<2>> made(Body<2> const& body, Boundary<2> const& boundary, double share = 0) {
    auto const kernel = make_kernel("w6", 2, support * body.dx);
    auto pressure = std::make_unique<MeanOnBoundary<2>>(
        std::make_unique<ConsistentPressure<2>>(kernel, GradientKind::corrected, share));
    pressure->set_boundary(boundary);
    return pressure;
}

double torque(Body<2> const& body) {
    auto const view = body.particles.view();
    return sum_over(body.particles.size(), 0.0, [&](std::size_t i) {
        auto const x = view.template get<Position>(i), a = view.template get<Acceleration>(i);
        return view.template at<Mass>()[i] * (x[0] * a[1] - x[1] * a[0]);
    });
}

}  // namespace

TEST(MeanOnBoundary, IsSymmetricAndPositive) {
    for (double const share : {0.0, 0.05}) {
        auto const b = body<2>(8, 0.3, support);
        auto const boundary = boundary_of(*b);
        auto const A = made(*b, boundary, share);
        A->set_up(b->particles, b->neighbours);
        std::size_t const n = b->particles.size();
        auto const p = random_numbers(n, 1), q = random_numbers(n, 2);
        std::vector<double> Ap(n), Aq(n), A1(n);
        A->apply(p, Ap);
        A->apply(q, Aq);
        A->apply(std::vector<double>(n, 1.0), A1);
        EXPECT_NEAR(inner_product(q, Ap), inner_product(p, Aq), 1e-13 * inner_product(p, Ap));
        EXPECT_GT(inner_product(std::vector<double>(n, 1.0), A1), 0);
    }
}

TEST(MeanOnBoundary, ForceAndDivergenceAreDual) {
    auto const b = body<2>(8, 0.3, support);
    auto const boundary = boundary_of(*b);
    auto const A = made(*b, boundary);
    A->set_up(b->particles, b->neighbours);
    std::size_t const n = b->particles.size();
    auto const p = random_numbers(n, 1), vx = random_numbers(n, 3), vy = random_numbers(n, 4);
    std::vector<Vector<double, 2>> v(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = {{vx[i], vy[i]}};
    std::vector<double> divergence(n);
    A->divergence(v, divergence);
    A->accelerate(p);
    auto const view = b->particles.view();
    double const power =
        sum_over(n, 0.0, [&](std::size_t i) { return view.at<Mass>()[i] * dot(view.get<Acceleration>(i), v[i]); });
    EXPECT_NEAR(power, inner_product(p, divergence), 1e-12 * std::fabs(power));
}

TEST(MeanOnBoundary, AConstantPressurePushesOnTheBoundaryAlone) {
    auto const b = body<2>(10, 0.3, support);
    auto const boundary = boundary_of(*b);
    auto const A = made(*b, boundary);
    A->set_up(b->particles, b->neighbours);
    A->accelerate(std::vector<double>(b->particles.size(), 3.0));
    auto const view = b->particles.view();
    for (std::size_t i = 0; i < b->particles.size(); ++i)
        EXPECT_LT(norm2(view.at<Mass>()[i] * view.get<Acceleration>(i) - 3.0 * boundary.of_content[i]), 1e-24);
}

TEST(MeanOnBoundary, ConservesMomentumAndAngularMomentum) {
    auto const b = body<2>(8, 0.3, support);
    auto const boundary = boundary_of(*b);
    auto const A = made(*b, boundary);
    A->set_up(b->particles, b->neighbours);
    std::size_t const n = b->particles.size();
    A->accelerate(random_numbers(n, 5));
    auto const view = b->particles.view();
    double const forces = sum_over(
        n, 0.0, [&](std::size_t i) { return view.at<Mass>()[i] * std::sqrt(norm2(view.get<Acceleration>(i))); });
    auto const sum =
        sum_over(n, Vector<double, 2>{}, [&](std::size_t i) { return view.at<Mass>()[i] * view.get<Acceleration>(i); });
    EXPECT_LT(std::sqrt(norm2(sum)), 1e-14 * forces);
    EXPECT_LT(std::fabs(torque(*b)), 1e-14 * forces);
}

TEST(MeanOnBoundary, LeavesNoDivergenceAndTheContentAsItIs) {
    auto const b = body<2>(10, 0.3, support);
    auto const boundary = boundary_of(*b);
    auto pressure = made(*b, boundary);
    Projection<2> projection(std::move(pressure), Preconditioning::jacobi, b->dx, {1e-10, 4000});
    auto const view = b->particles.view();
    std::size_t const n = b->particles.size();
    auto const vx = random_numbers(n, 3), vy = random_numbers(n, 4);
    for (std::size_t i = 0; i < n; ++i) view.set<Velocity>(i, {{vx[i], vy[i]}});
    auto const rate = [&] {
        return sum_over(n, 0.0, [&](std::size_t i) { return dot(boundary.of_content[i], view.get<Velocity>(i)); });
    };
    double const before = rate();
    EXPECT_TRUE(projection.project(b->particles, b->neighbours, 1e-3).converged);
    EXPECT_LT(std::fabs(rate()), 1e-8 * std::fabs(before));
    EXPECT_LT(projection.largest_divergence(b->particles), 1e-7 / b->dx);  // of speeds of 1 m/s
}

}  // namespace coronet
