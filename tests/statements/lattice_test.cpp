// SPDX-License-Identifier: BSD-3-Clause

// Whether a square lattice stays where it is under an even pressure is a matter of the kernel:
// bench/lattice_stability.py.

#include <numbers>

#include <gtest/gtest.h>

#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

namespace {

/// A square lattice of spacing 1 and density 1 in a periodic box of n x n, under pressure 1, displaced by a wave of m
/// lengths along x: the acceleration over the displacement, along y [1/s^2].
double answer_to_a_shear_wave(std::string const& kernel, double support, int n, int m) {
    double const k = 2 * std::numbers::pi * m / n, small = 1e-5;
    WeaklyCompressible<2>::Settings s;
    s.kernel = make_kernel(kernel, 2, support);
    s.gradient = Gradient::sph;
    s.equation_of_state = {EquationOfState::Kind::linear, 0.99, 10, 7};
    s.box.periodic[0] = s.box.periodic[1] = true;
    s.box.low = {{-0.5, -0.5}};
    s.box.size = {{1.0 * n, 1.0 * n}};
    Particles<2> particles(static_cast<std::size_t>(n * n));
    particles.allocate(Fields<Position, Velocity, Density, Mass>{});
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        double const x = static_cast<double>(i % n), y = static_cast<double>(i / n);
        view.set<Position>(i, {{x, y + small * std::cos(k * x)}});
        view.set<Density>(i, 1);
        view.set<Mass>(i, 1);
    }
    WeaklyCompressible<2> scheme(s, std::move(particles));
    scheme.evaluate(0);
    auto const after = scheme.particles().view();
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < scheme.particles().owned(); ++i) {
        double const u = small * std::cos(k * after.get<Position>(i)[0]);
        sum += u * after.get<Acceleration>(i)[1];
        squares += u * u;
    }
    return sum / squares;
}

}  // namespace

TEST(SquareLattice, StaysUnderPressureOrGivesWayAsItsKernelHasIt) {
    // -(2 p/rho) D(k), D(k) = sum V (W'' y^2/r^2 + W'/r x^2/r^2) (1 - cos k x), by hand for 12 spacings.
    auto const theory = [](double support, int n, int m, auto const& first, auto const& second) {
        double D = 0;
        double const k = 2 * std::numbers::pi * m / n;
        int const reach = static_cast<int>(support) + 1;
        for (int x = -reach; x <= reach; ++x)
            for (int y = -reach; y <= reach; ++y) {
                double const r2 = x * x + y * y, r = std::sqrt(r2);
                if (r == 0 || r >= support) continue;
                D += (second(r) * y * y / r2 + first(r) / r * x * x / r2) * (1 - std::cos(k * x));
            }
        return -2 * D;
    };
    double const H = 3, c = 7 / (std::numbers::pi * H * H * H);
    auto const first = [&](double r) { return c * -20 * (r / H) * std::pow(1 - r / H, 3); };
    auto const second = [&](double r) {
        return c / H * (-20 * std::pow(1 - r / H, 3) + 60 * (r / H) * std::pow(1 - r / H, 2));
    };
    for (int const m : {1, 2, 6}) {
        double const expected = theory(H, 12, m, first, second);
        // The displacement is 1e-5 of a spacing, and the next term of the force of its square.
        EXPECT_NEAR(answer_to_a_shear_wave("wendland-c2", H, 12, m), expected, 1e-7) << m;
    }
    EXPECT_GT(answer_to_a_shear_wave("wendland-c2", 3.0, 12, 1), 1e-3) << "a long wave grows";
    for (int m = 1; m <= 6; ++m) EXPECT_LT(answer_to_a_shear_wave("quintic-spline", 2.7, 12, m), -1e-4) << m;
}

}  // namespace coronet
