// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/thesis_pressure.hpp"

#include <gtest/gtest.h>

#include "coronet/schemes/projection.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double support = 3.5;

Kernel w3(Body<2> const& b) { return make_kernel("w3", 2, support * b.dx); }

}  // namespace

TEST(ThesisPressure, IsTheThesissLaplacianTimesTheVolume) {
    auto const b = body<2>(8, 0.2, support);
    ThesisPressure<2> A(w3(*b), {SurfacePressure::free, b->dx});
    A.set_up(b->particles, b->neighbours);
    std::size_t const n = b->particles.size();
    auto const p = random_numbers(n, 4);
    std::vector<double> Ap(n);
    A.apply(p, Ap);
    auto const view = b->particles.view();
    double const rho = 1000, m = rho * b->dx * b->dx;
    for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;  // Eq 3.61
        for (std::size_t j = 0; j < n; ++j)
            if (j != i)
                sum += 8 * m / (4 * rho * rho) * (p[i] - p[j]) *
                       w3(*b)(norm2(view.get<Position>(i) - view.get<Position>(j))).F;
        EXPECT_NEAR(Ap[i], -b->dx * b->dx * sum, 1e-13 * A.diagonal()[i]);
    }
}

TEST(ThesisPressure, OfAConstantIsNothingWhereTheSurfaceIsFree) {
    auto const b = body<2>(10, 0.3, support);
    ThesisPressure<2> A(w3(*b), {SurfacePressure::free, b->dx});
    A.set_up(b->particles, b->neighbours);
    std::size_t const n = b->particles.size();
    std::vector<double> A1(n);
    A.apply(std::vector<double>(n, 1.0), A1);
    for (std::size_t i = 0; i < n; ++i) EXPECT_LT(std::fabs(A1[i]), 1e-13 * A.diagonal()[i]);
}

TEST(ThesisPressure, LeavesSurfaceParticlesAtZero) {
    auto const b = body<2>(12, 0.1, support);
    set_smooth_velocity(b->particles);
    Projection<2> projection(
        std::make_unique<ThesisPressure<2>>(w3(*b), ThesisPressure<2>::Options{SurfacePressure::zero, b->dx, false}),
        Preconditioning::multigrid, b->dx, {1e-8, 1000});
    EXPECT_TRUE(projection.project(b->particles, b->neighbours, 1e-3).converged);
    for (std::size_t i = 0; i < b->particles.size(); ++i) {
        double const p = b->particles.get<Pressure>()[i];
        if (b->particles.get<Surface>()[i] > 0) EXPECT_EQ(p, 0);
        else EXPECT_NE(p, 0);
    }
}

TEST(ThesisPressure, MirroredKeepsTheDepthBelowAFlatSurface) {
    // p = depth below the plane half a spacing above the upper row: odd in the images, so that the row of a surface
    // particle has a whole neighbourhood in which p is linear, and no Laplacian.
    double const dx = 0.1;
    Particles<2> particles(21 * 9);
    particles.allocate<Position, Velocity, Mass, Density, Volume, Surface>();
    auto const view = particles.view();
    for (int a = 0; a < 21; ++a)
        for (int b = 0; b < 9; ++b) {
            auto const i = static_cast<std::size_t>(9 * a + b);
            view.set<Position>(i, {{a * dx, -b * dx}});
            view.set<Volume>(i, dx * dx);
            view.set<Density>(i, 1000.0);
            view.set<Mass>(i, 1000 * dx * dx);
            view.set<Surface>(i, b == 0 ? 1 : 0);
        }
    Neighbours<2> neighbours(support * dx, 0.01 * dx);
    neighbours.update(particles);
    ThesisPressure<2> A(make_kernel("w3", 2, support * dx), {SurfacePressure::mirrored, dx});
    A.set_normals(std::vector<Vector<double, 2>>(particles.size(), {{0, 1}}));
    A.set_up(particles, neighbours);
    std::vector<double> p(particles.size()), Ap(particles.size());
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = 0.5 * dx - view.get<Position>(i)[1];
    A.apply(p, Ap);
    int looked_at = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        auto const x = view.get<Position>(i);
        if (view.get<Surface>(i) == 0 || std::fabs(x[0] - 1) > 0.65) continue;
        EXPECT_LT(std::fabs(Ap[i]), 1e-13 * A.diagonal()[i] * dx);
        ++looked_at;
    }
    EXPECT_EQ(looked_at, 13);
}

TEST(ThesisPressure, AsksForNormalsToMirrorAt) {
    auto const b = body<2>(5, 0, support);
    ThesisPressure<2> A(w3(*b), {SurfacePressure::mirrored, b->dx});
    EXPECT_THROW(A.set_up(b->particles, b->neighbours), std::invalid_argument);
}

TEST(ThesisPressure, WithMultigridTakesAsManyIterationsForAnyNumberOfParticles) {
    auto const iterations = [](int spacings, Preconditioning preconditioning) {
        auto const b = body<2>(spacings, 0.2, support);
        set_smooth_velocity(b->particles);
        auto A = std::make_unique<ThesisPressure<2>>(
            w3(*b), ThesisPressure<2>::Options{SurfacePressure::mirrored, b->dx, false});
        A->set_normals(b->normals);
        Projection<2> projection(std::move(A), preconditioning, b->dx, {1e-8, 1000});
        auto const solved = projection.project(b->particles, b->neighbours, 1e-3);
        EXPECT_TRUE(solved.converged);
        return solved.iterations;
    };
    EXPECT_LT(iterations(64, Preconditioning::multigrid), iterations(16, Preconditioning::multigrid) + 5);
    EXPECT_LT(iterations(64, Preconditioning::multigrid), 22);
    EXPECT_GT(iterations(64, Preconditioning::jacobi), 2.5 * iterations(16, Preconditioning::jacobi));
}

}  // namespace coronet
