// SPDX-License-Identifier: BSD-3-Clause

// What the forces of the weakly compressible scheme conserve on a disordered body with a free surface: momentum with
// every gradient, angular momentum with the gradient that is exact for linear fields, and the balance of energy.

#include <gtest/gtest.h>

#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

constexpr double eps = 2.3e-16;

template <int D>
void expect_no_net_force(std::string const& gradient) {
    auto const scheme = liquid<D>({.gradient = gradient});
    auto const view = scheme->particles().view();
    for (int k = 0; k < D; ++k) {
        auto const [force, size] = sum_and_size(scheme->particles().owned(), [&](std::size_t i) {
            return view.template get<Mass>(i) * view.template at<Acceleration>(k)[i];
        });
        // Each force is a sum of some 30 pair forces that partly cancel: hence the factor over the sum of net forces.
        EXPECT_NEAR(force, 0, 100 * eps * size) << gradient << ", component " << k;
    }
}

/// The torque about the origin over the sum of its parts, the largest of all components.
template <int D>
double relative_torque(std::string const& gradient) {
    auto const scheme = liquid<D>({.gradient = gradient});
    auto const view = scheme->particles().view();
    double worst = 0;
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b) {
            auto const [torque, size] = sum_and_size(scheme->particles().owned(), [&](std::size_t i) {
                auto const x = view.template get<Position>(i);
                auto const dv = view.template get<Acceleration>(i);
                return view.template get<Mass>(i) * (x[a] * dv[b] - x[b] * dv[a]);
            });
            worst = std::max(worst, std::fabs(torque) / size);
        }
    return worst;
}

/// Power of the stress forces plus the rate at which the stress stores or dissipates energy, over the latter's size:
/// zero if force and velocity gradient are dual, Fang et al. (2009) Eqs 44 and 53. With a Newtonian stress this is
///     sum m v . dv - sum V (p div v - 2 eta d : d).
template <int D>
double energy_imbalance(std::string const& gradient) {
    auto const scheme = liquid<D>({.gradient = gradient, .viscosity = 0});
    auto const view = scheme->particles().view();
    auto const n = scheme->particles().owned();
    auto const [power, power_size] = sum_and_size(n, [&](std::size_t i) {
        return view.template get<Mass>(i) * dot(view.template get<Velocity>(i), view.template get<Acceleration>(i));
    });
    auto const [work, work_size] = sum_and_size(n, [&](std::size_t i) {
        return -view.template get<Volume>(i) * view.template get<Pressure>(i) * view.template get<DensityRate>(i) /
               view.template get<Density>(i);
    });
    return std::fabs(power - work) / (power_size + work_size);
}

}  // namespace

TEST(Momentum, IsConservedByEveryGradient) {
    for (std::string const gradient : {"sph", "cph", "fpm"}) {
        expect_no_net_force<2>(gradient);
        expect_no_net_force<3>(gradient);
    }
}

TEST(AngularMomentum, IsConservedByTheExactGradientOnly) {
    EXPECT_LT(relative_torque<2>("fpm"), 100 * eps);
    EXPECT_LT(relative_torque<3>("fpm"), 100 * eps);
    for (std::string const gradient : {"sph", "cph"}) {
        EXPECT_GT(relative_torque<2>(gradient), 1e-6) << "on disordered particles " << gradient << " should fail";
        EXPECT_GT(relative_torque<3>(gradient), 1e-6) << "on disordered particles " << gradient << " should fail";
    }
}

TEST(AngularMomentum, IsConservedWhereNeighboursDoNotSpanSpace) {
    // A row of particles that turns, beside a body: the plain gradient would take the turn for a shear.
    auto const c = read_case(
        "name = 'row'\ndimension = 2\n[[shapes]]\nkind = 'box'\nsize = [1, 0.01]\n[[shapes]]\nkind = 'box'\n"
        "centre = [0.8, 0]\nsize = [0.41, 0.61]\n[particles]\nspacing = 0.1\njitter = 0.1\n[initial]\n"
        "velocity = ['-3*y + x*y', '3*x']\npressure = '5 + x'\n[fluid]\ndensity = 1\nviscosity = 0.5\n"
        "sound_speed = 20\n[time]\nend = 0.1\n",
        "row");
    auto const scheme = make_scheme<2>(c);
    scheme->begin_step(0);
    EXPECT_GT(scheme->counters().singular_now, 3);
    auto const view = scheme->particles().view();
    auto const [torque, size] = sum_and_size(scheme->particles().owned(), [&](std::size_t i) {
        auto const x = view.get<Position>(i), dv = view.get<Acceleration>(i);
        return view.get<Mass>(i) * (x[0] * dv[1] - x[1] * dv[0]);
    });
    EXPECT_NEAR(torque, 0, 100 * eps * size);
}

TEST(Energy, PressureForcesDoTheWorkThatCompressionTakes) {
    for (std::string const gradient : {"sph", "cph", "fpm"}) {
        EXPECT_LT(energy_imbalance<2>(gradient), 100 * eps) << gradient;
        EXPECT_LT(energy_imbalance<3>(gradient), 100 * eps) << gradient;
    }
}

TEST(Energy, ViscosityTakesItAway) {
    for (std::string const gradient : {"sph", "cph", "fpm"}) {
        auto const power = [&](double viscosity) {
            auto const scheme = liquid<2>({.gradient = gradient, .viscosity = viscosity});
            auto const view = scheme->particles().view();
            return sum_and_size(scheme->particles().owned(),
                                [&](std::size_t i) {
                                    return view.get<Mass>(i) * dot(view.get<Velocity>(i), view.get<Acceleration>(i));
                                })
                .first;
        };
        EXPECT_LT(power(1), power(0)) << gradient;
        // The viscous power is linear in the viscosity.
        EXPECT_NEAR(power(2) - power(0), 2 * (power(1) - power(0)), 1e-12 * std::fabs(power(2))) << gradient;
    }
}

/// The corrected pressure force beside the viscous force of Morris is that of the stress, in another form; the viscous
/// force keeps momentum, and not its moment.
TEST(MorrisViscosity, WithCorrectedGradientsKeepsMomentumAndLeavesThePressureForceAsItIs) {
    auto const accelerations = [](std::string const& force, double viscosity) {
        auto const scheme = make_scheme<3>([&] {
            Case c = liquid_case<3>({.viscosity = viscosity});
            c.method.viscous_force = force;
            return c;
        }());
        scheme->begin_step(0);
        std::vector<Vector<double, 3>> all(scheme->particles().owned());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[static_cast<std::size_t>(scheme->particles().id[i])] =
                scheme->particles().view().get<Mass>(i) * scheme->particles().view().get<Acceleration>(i);
        return all;
    };
    auto const stress = accelerations("stress", 0), morris = accelerations("morris", 0),
               viscous = accelerations("morris", 1);
    Vector<double, 3> sum{};
    double worst = 0, size = 0;
    for (std::size_t i = 0; i < stress.size(); ++i) {
        worst = std::max(worst, std::sqrt(norm2(stress[i] - morris[i])));
        sum += viscous[i];
        size += std::sqrt(norm2(viscous[i]));
    }
    EXPECT_LT(worst, 100 * eps * size / static_cast<double>(stress.size()));
    EXPECT_LT(std::sqrt(norm2(sum)), 100 * eps * size);
}

TEST(Viscosity, DoesNotFeelRigidRotationWithTheExactGradient) {
    auto const largest_difference = [](std::string const& gradient) {
        LiquidOptions const turning{.gradient = gradient, .viscosity = 0, .step = 1e-7, .velocity_2d = "'-3*y', '3*x'"};
        LiquidOptions viscous = turning;
        viscous.viscosity = 100;
        auto const a = liquid<2>(turning), b = liquid<2>(viscous);
        double worst = 0;
        for (int k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < a->particles().owned(); ++i)
                worst = std::max(
                    worst, std::fabs(a->particles().get<Acceleration>(k)[i] - b->particles().get<Acceleration>(k)[i]));
        return worst;
    };
    // A shear rate of 1/s would give stresses of 100 Pa and accelerations of some 100/spacing, over 1000 m/s^2.
    EXPECT_LT(largest_difference("fpm"), 1e-9);
    EXPECT_GT(largest_difference("sph"), 1);
}

TEST(DriftOfAngularMomentum, IsRoundOffWithMeanVelocityAndSecondOrderAsPrinted) {
    auto const drift = [](std::string const& update, double step) {
        auto const c = liquid_case<2>({.step = step, .more = "position_update = '" + update + "'"});
        auto const scheme = make_scheme<2>(c);
        double const first = totals(scheme->particles()).angular_momentum[2];
        int const steps = static_cast<int>(std::lround(0.02 / step));
        for (int n = 0; n < steps; ++n) {
            scheme->begin_step(n * step);
            scheme->advance(n * step, step);
        }
        return std::fabs(totals(scheme->particles()).angular_momentum[2] / first - 1);
    };
    EXPECT_LT(drift("mean-velocity", 1e-3), 1e-14);
    double const coarse = drift("midpoint-velocity", 1e-3), fine = drift("midpoint-velocity", 5e-4);
    EXPECT_GT(coarse, 1e-10);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3);
}

}  // namespace coronet
