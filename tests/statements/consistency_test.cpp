// SPDX-License-Identifier: BSD-3-Clause

// What the interpolation operators reproduce on randomly perturbed particles with a free surface, and what happens
// where the small matrices of the finite particle method are singular.

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "coronet/cases/fill.hpp"
#include "coronet/schemes/operators.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

template <int D>
Particles<D> points(std::vector<Vector<double, D>> const& positions, double volume) {
    Particles<D> particles(positions.size());
    particles.template allocate<Position, Volume, Sample>();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        particles.view().template set<Position>(i, positions[i]);
        particles.view().template set<Volume>(i, volume);
    }
    return particles;
}

/// Largest errors in value and gradient for f = 3 + slope . x with |slope| about 3, over all particles.
struct Errors {
    double sph, shepard, fpm, sph_gradient, axis_gradient, fpm_gradient;
    int fell_back;
};

template <int D>
Errors errors_on_linear_field(std::vector<Vector<double, D>> const& positions, double volume, double support) {
    auto particles = points<D>(positions, volume);
    Vector<double, D> slope;
    for (int k = 0; k < D; ++k) slope[k] = k == 0 ? 2 : k == 1 ? -1.5 : 1;
    auto const view = particles.view();
    auto const exact = [&](std::size_t i) { return 3 + dot(slope, view.template get<Position>(i)); };
    for (std::size_t i = 0; i < particles.size(); ++i) view.template set<Sample>(i, exact(i));
    Neighbours<D> neighbours(support, 0.1 * support);
    neighbours.update(particles);
    for (std::size_t i = 0; i < particles.size(); ++i) view.template set<Sample>(i, exact(i));
    auto const values = interpolate(particles, neighbours, make_kernel("quintic-spline", D, support));
    Errors e{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto const& at = values[i];
        auto const worse = [](double& worst, double error) { worst = std::max(worst, std::fabs(error)); };
        worse(e.sph, at.sph - exact(i));
        worse(e.shepard, at.shepard - exact(i));
        worse(e.fpm, at.fpm - exact(i));
        for (int k = 0; k < D; ++k) {
            worse(e.sph_gradient, at.sph_gradient[k] - slope[k]);
            worse(e.axis_gradient, at.axis_gradient[k] - slope[k]);
            worse(e.fpm_gradient, at.fpm_gradient[k] - slope[k]);
        }
        e.fell_back += at.fell_back;
    }
    return e;
}

}  // namespace

TEST(FiniteParticleMethod, IsExactForLinearFieldsOnDisorderedParticlesWithAFreeSurface) {
    auto const c2 = liquid_case<2>({});
    auto const seeds2 = fill<2>(c2);
    Errors const e2 = errors_on_linear_field<2>(seeds2.position, seeds2.volume, 3.9 * c2.particles.spacing);
    EXPECT_LT(e2.fpm, 1e-12);
    EXPECT_LT(e2.fpm_gradient, 1e-11);
    EXPECT_EQ(e2.fell_back, 0);
    EXPECT_GT(e2.sph_gradient, 0.5) << "half a support is missing at the surface: plain SPH cannot be right there";
    EXPECT_GT(e2.sph, 0.5);
    EXPECT_GT(e2.shepard, 0.01) << "the Shepard mean is exact for constants only";
    EXPECT_GT(e2.axis_gradient, 0.01) << "off-diagonal moments do not vanish on disordered particles";

    auto const c3 = liquid_case<3>({});
    auto const seeds3 = fill<3>(c3);
    Errors const e3 = errors_on_linear_field<3>(seeds3.position, seeds3.volume, 2.6 * c3.particles.spacing);
    EXPECT_LT(e3.fpm, 1e-12);
    EXPECT_LT(e3.fpm_gradient, 1e-11);
    EXPECT_EQ(e3.fell_back, 0);
    EXPECT_GT(e3.sph_gradient, 0.5);
}

TEST(FiniteParticleMethod, IsTheSolutionOfItsWholeMatrix) {
    // The (D + 1) x (D + 1) system of Fang et al. (2009), Eqs 28-34, summed over all pairs and solved by Eigen.
    auto const c = liquid_case<3>({});
    auto const seeds = fill<3>(c);
    double const support = 2.6 * c.particles.spacing;
    Kernel const kernel = make_kernel("quintic-spline", 3, support);
    auto particles = points<3>(seeds.position, seeds.volume);
    Neighbours<3> neighbours(support, 0.1 * support);
    neighbours.update(particles);
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto const x = view.get<Position>(i);
        view.set<Sample>(i, std::sin(2 * x[0]) + x[1] * x[2]);
    }
    auto const values = interpolate(particles, neighbours, kernel);
    for (std::size_t i = 0; i < particles.size(); i += 7) {
        Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
        Eigen::Vector4d B = Eigen::Vector4d::Zero();
        for (std::size_t j = 0; j < particles.size(); ++j) {
            auto const x = view.get<Position>(i) - view.get<Position>(j);
            auto const [W, F] = kernel(norm2(x));
            Eigen::Vector4d const weight{W, F * x[0], F * x[1], F * x[2]}, basis{1, -x[0], -x[1], -x[2]};
            A += seeds.volume * weight * basis.transpose();
            B += seeds.volume * view.get<Sample>(j) * weight;
        }
        Eigen::Vector4d const exact = A.fullPivLu().solve(B);
        EXPECT_NEAR(values[i].fpm, exact[0], 1e-12);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(values[i].fpm_gradient[k], exact[k + 1], 1e-11);
    }
}

TEST(AxisGradient, IsExactInsideALatticeWhereOffDiagonalMomentsVanish) {
    std::vector<Vector<double, 2>> lattice;
    for (int a = -5; a <= 5; ++a) lattice.push_back({{0.1 * a, 0}});
    for (int a = -5; a <= 5; ++a) lattice.push_back({{0.1 * a, 0.1}});
    for (int a = -5; a <= 5; ++a) lattice.push_back({{0.1 * a, -0.1}});
    auto particles = points<2>(lattice, 0.01);
    Neighbours<2> neighbours(0.3, 0.01);
    auto const view = particles.view();
    neighbours.update(particles);
    for (std::size_t i = 0; i < particles.size(); ++i)
        view.set<Sample>(i, 2 * view.get<Position>(i)[0] - view.get<Position>(i)[1]);
    auto const values = interpolate(particles, neighbours, make_kernel("w6", 2, 0.3));
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (norm2(view.get<Position>(i)) > 1e-9) continue;
        EXPECT_NEAR(values[i].axis_gradient[0], 2, 1e-14);
        EXPECT_NEAR(values[i].axis_gradient[1], -1, 1e-14);
    }
}

TEST(SingularMatrices, FallBackToThePlainGradientAndAreCounted) {
    std::vector<Vector<double, 2>> const alone{{{0, 0}}}, two{{{0, 0}}, {{0.5, 0.3}}},
        row{{{0, 0}}, {{0.4, 0.2}}, {{0.8, 0.4}}}, coincident{{{0, 0}}, {{0, 0}}, {{0, 0}}},
        nearly_a_row{{{0, 0}}, {{0.4, 0.2}}, {{0.8, 0.4 + 1e-9}}};
    for (auto const& cloud : {alone, two, row, coincident, nearly_a_row}) {
        Errors const e = errors_on_linear_field<2>(cloud, 0.25, 1.0);
        EXPECT_EQ(e.fell_back, static_cast<int>(cloud.size()));
        EXPECT_TRUE(std::isfinite(e.fpm) && std::isfinite(e.fpm_gradient));
        EXPECT_EQ(e.fpm_gradient, e.sph_gradient);
    }
    std::vector<Vector<double, 3>> const plane{{{0, 0, 0}}, {{0.5, 0, 0}}, {{0, 0.5, 0}}, {{0.4, 0.4, 0}}};
    EXPECT_EQ(errors_on_linear_field<3>(plane, 0.1, 1.0).fell_back, 4);
    // Three particles that do span the plane are enough, if they are near.
    std::vector<Vector<double, 2>> const triangle{{{0, 0}}, {{0.35, 0}}, {{0.15, 0.35}}};
    Errors const e = errors_on_linear_field<2>(triangle, 0.25, 1.0);
    EXPECT_EQ(e.fell_back, 0);
    EXPECT_LT(e.fpm_gradient, 1e-12);
}

TEST(SingularMatrices, OfASplashDropAreCountedByTheSchemeAndLeaveNoNaN) {
    auto const c = read_case(
        "name = 'row'\ndimension = 2\n[[shapes]]\nkind = 'box'\nsize = [1, 0.01]\n[particles]\nspacing = 0.1\n"
        "[initial]\nvelocity = ['x', '-y']\n[fluid]\ndensity = 1000\nsound_speed = 10\n[time]\nend = 0.01\n",
        "row");
    auto const scheme = make_scheme<2>(c);
    scheme->begin_step(0);
    EXPECT_EQ(scheme->counters().singular_now, 11);
    for (double const a : scheme->particles().get<Acceleration>()) EXPECT_TRUE(std::isfinite(a));
}

}  // namespace coronet
