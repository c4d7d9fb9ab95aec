// SPDX-License-Identifier: BSD-3-Clause

// What a way of stepping does to sound and to what is conserved: forward Euler amplifies sound, symplectic Euler does
// not, at one evaluation a step.

#include <gtest/gtest.h>

#include <numbers>

#include "coronet/schemes/weakly_compressible.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

constexpr double c = 10, p0 = 1, omega = c * pi * std::numbers::sqrt2;

/// A square of side 1 in its lowest standing wave, p = p0 cos(pi x) cos(pi y), at rest, of frequency omega.
std::unique_ptr<Scheme<2>> square_with_sound(std::string const& stepping, std::string const& gradient) {
    return make_scheme<2>(
        read_case(fmt::format("name = 'sound'\ndimension = 2\n[[shapes]]\nkind = 'box'\nsize = [1, 1]\n"
                              "[particles]\nspacing = 0.05\norigin = 'cell'\n"
                              "[initial]\npressure = '{}*cos(pi*x)*cos(pi*y)'\n"
                              "[fluid]\ndensity = 1000\nsound_speed = {}\n"
                              "[method]\ngradient = '{}'\nkernel = 'cubic-spline'\nsupport = 2.6\n"
                              "[time]\nend = 1\nstepping = '{}'\n",
                              p0, c, gradient, stepping),
                  "sound"));
}

/// The square of the wave's amplitude over p0^2: of its share in the pressure and of that in the velocity.
double size(Scheme<2>& scheme) {
    scheme.refresh();
    auto const view = scheme.particles().view();
    double p = 0, v = 0, of_p = 0, of_v = 0;
    for (std::size_t i = 0; i < scheme.particles().owned(); ++i) {
        auto const x = view.get<Position>(i);
        double const wave = std::cos(pi * x[0]) * std::cos(pi * x[1]);
        Vector<double, 2> const slope{
            {std::sin(pi * x[0]) * std::cos(pi * x[1]), std::cos(pi * x[0]) * std::sin(pi * x[1])}};
        p += view.get<Pressure>(i) * wave;
        v += dot(view.get<Velocity>(i), slope);
        of_p += wave * wave;
        of_v += norm2(slope);
    }
    // In a wave p0 cos(omega t) the velocity is slope p0/(rho c sqrt 2) sin(omega t).
    return std::pow(p / of_p / p0, 2) + std::pow(std::numbers::sqrt2 * 1000 * c * v / of_v / p0, 2);
}

void forward_euler(Scheme<2>& scheme, double dt) {
    dynamic_cast<WeaklyCompressible<2>&>(scheme).evaluate(0);
    auto const view = scheme.particles().view();
    for (std::size_t i = 0; i < scheme.particles().owned(); ++i) {
        view.set<Position>(i, view.get<Position>(i) + dt * view.get<Velocity>(i));
        view.set<Velocity>(i, view.get<Velocity>(i) + dt * view.get<Acceleration>(i));
        view.set<Density>(i, view.get<Density>(i) + dt * view.get<DensityRate>(i));
    }
}

/// d ln(size)/dt over two periods.
template <class Step>
double growth(Scheme<2>& scheme, double dt, Step const& step) {
    double const first = size(scheme);
    int const steps = static_cast<int>(std::lround(4 * pi / omega / dt));
    for (int k = 0; k < steps; ++k) step(scheme, dt);
    return std::log(size(scheme) / first) / (steps * dt);
}

void one_step(Scheme<2>& scheme, double dt) {
    scheme.begin_step(0);
    scheme.advance(0, dt);
}

}  // namespace

TEST(Sound, IsAmplifiedByForwardEulerAsTheFormulaSays) {
    auto const scheme = square_with_sound("predictor-corrector", "fpm");
    // A factor |1 + i omega dt| a step. The wave of the discrete square is slower by some percent, at 20 particles a
    // side. The step is a tenth of the usual one: with that, short waves outgrow this one within two periods.
    constexpr double dt = 1e-4, expected = omega * omega * dt;
    EXPECT_NEAR(growth(*scheme, dt, forward_euler), expected, 0.1 * expected);
}

TEST(Sound, IsNotAmplifiedBySymplecticEuler) {
    constexpr double dt = 1e-3;
    for (std::string const gradient : {"sph", "cph", "fpm"}) {
        auto const scheme = square_with_sound("symplectic-euler", gradient);
        // p^2 + v^2 + omega dt p v is kept, so the size comes and goes by omega dt, and after two periods has come back
        // up to what the discrete wave's frequency differs. Forward Euler would give 1.97/s.
        EXPECT_LT(std::fabs(growth(*scheme, dt, one_step)), 0.2) << gradient;
        EXPECT_EQ(scheme->counters().evaluations, std::lround(4 * pi / omega / dt)) << "one evaluation a step";
    }
}

TEST(SymplecticEuler, KeepsMomentumAndItsMomentToRoundOff) {
    for (std::string const gradient : {"sph", "cph", "fpm"}) {
        auto const scheme = make_scheme<2>(
            liquid_case<2>({.gradient = gradient, .step = 1e-3, .more = "stepping = 'symplectic-euler'"}));
        auto const before = totals(scheme->particles());
        for (int n = 0; n < 20; ++n) {
            scheme->begin_step(n * 1e-3);
            scheme->advance(n * 1e-3, 1e-3);
        }
        auto const after = totals(scheme->particles());
        for (int k = 0; k < 2; ++k)
            EXPECT_NEAR(after.momentum[k], before.momentum[k], 1e-14 * before.momentum_scale) << gradient;
        if (gradient == "fpm") {
            EXPECT_NEAR(after.angular_momentum[2] / before.angular_momentum[2], 1, 1e-14);
        }
    }
}

}  // namespace coronet
