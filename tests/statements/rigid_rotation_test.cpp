// SPDX-License-Identifier: BSD-3-Clause

// A liquid that turns as a rigid body is not sheared, so no law of viscosity may see a shear rate in it: not at the
// free surface, not on disordered particles, whatever the axis. Shown with what the sweeps of the schemes leave in the
// field Viscosity.

#include <gtest/gtest.h>

#include "coronet/schemes/incompressible.hpp"
#include "coronet/schemes/weakly_compressible.hpp"
#include "tests/schemes/bodies.hpp"

namespace coronet {

namespace {

constexpr double support = 3, omega = 30, seen_at_most = 1e-10 * omega;  // the rate in 1/s

/// Of a rotation about an axis off the middle, on top of a translation; in 3D along (1, 2, 2).
template <int D>
Vector<double, D> rigid(Vector<double, D> const& x) {
    Vector<double, D> const r = x - Vector<double, D>{{0.4, -0.3}};
    Vector<double, D> v{{-omega * r[1], omega * r[0]}};
    if constexpr (D == 3) v = (omega / 3) * Vector<double, 3>{{2 * r[2] - 2 * r[1], 2 * r[0] - r[2], r[1] - 2 * r[0]}};
    return v + Vector<double, D>{{5, 1}};
}

template <int D>
std::unique_ptr<Body<D>> turning() {
    auto b = body<D>(D == 2 ? 20 : 6, 0.2, support);
    auto const view = b->particles.view();
    for (std::size_t i = 0; i < b->particles.size(); ++i)
        view.template set<Velocity>(i, rigid(view.template get<Position>(i)));
    return b;
}

template <int D>
std::vector<double> viscosities(Scheme<D> const& scheme) {
    EXPECT_EQ(scheme.counters().singular_now, 0);  // such a particle has the plain gradient, and sees something
    auto const mu = scheme.particles().template get<Viscosity>();
    return {mu.begin(), mu.end()};
}

template <int D>
std::vector<double> seen_by_weakly_compressible(Rheology const& law) {
    auto b = turning<D>();
    typename WeaklyCompressible<D>::Settings s;
    s.kernel = make_kernel("wendland-c2", D, support * b->dx);
    s.equation_of_state = {EquationOfState::Kind::linear, 1000, 400, 7};
    s.liquid.rheology = law;
    WeaklyCompressible<D> scheme(s, std::move(b->particles));
    scheme.evaluate(0);
    return viscosities(scheme);
}

template <int D>
std::vector<double> seen_by_projection(Rheology const& law, bool implicit, double step) {
    using Scheme = Incompressible<D>;
    auto b = turning<D>();
    typename Scheme::Settings s;
    s.kernel = s.pressure_kernel = make_kernel("wendland-c2", D, support * b->dx);
    s.liquid.rheology = law;
    s.viscous_step = implicit ? Scheme::Viscous::implicit_step : Scheme::Viscous::explicit_step;
    s.compact_share = 0.05;
    s.preconditioning = Preconditioning::jacobi;
    s.solve.tolerance = 0.1;
    s.surface.spacing = b->dx;
    Scheme scheme(s, std::move(b->particles));
    scheme.begin_step(0);
    scheme.advance(0, step);
    return viscosities(scheme);
}

/// see(mu of all particles) with every sweep, of steps so short that nothing moves.
template <class See>
void with_every_sweep(Rheology const& law, See const& see) {
    double const step = 1e-12 / omega;
    see(seen_by_weakly_compressible<2>(law));
    see(seen_by_weakly_compressible<3>(law));
    for (bool const implicit : {false, true}) {
        see(seen_by_projection<2>(law, implicit, step));
        see(seen_by_projection<3>(law, implicit, step));
    }
}

/// A liquid whose viscosity in Pa s is its shear rate in 1/s.
Rheology const shown{.model = Rheology::Model::power_law,
                     .consistency = 1,
                     .power_index = 2,
                     .shear_rate_min = 0,
                     .shear_rate_max = 1e9};

}  // namespace

TEST(RigidRotation, HasNoShearRateForAnySweep) {
    with_every_sweep(shown, [](std::vector<double> const& rates) {
        for (double const g : rates) EXPECT_LE(g, seen_at_most);
    });
}

TEST(RigidRotation, LeavesEveryLiquidAsThickAsAtRest) {
    using enum Rheology::Model;
    Rheology const laws[] = {// but the Newtonian one, which nothing changes
                             {.model = power_law, .consistency = 2, .power_index = 0.4},
                             {.model = power_law, .consistency = 2, .power_index = 1.6},
                             {.model = cross,
                              .zero_shear_viscosity = 5,
                              .infinite_shear_viscosity = 0.1,
                              .time_constant = 3,
                              .cross_exponent = 0.8},
                             {.model = carreau_yasuda,
                              .power_index = 0.3,
                              .zero_shear_viscosity = 5,
                              .infinite_shear_viscosity = 0.1,
                              .time_constant = 3,
                              .yasuda_exponent = 0.7},
                             {.model = bingham, .yield_stress = 4, .plastic_viscosity = 0.1},
                             {.model = herschel_bulkley, .consistency = 2, .power_index = 0.6, .yield_stress = 4},
                             {.model = casson, .yield_stress = 4, .plastic_viscosity = 0.1}};
    for (Rheology const& law : laws) {
        std::string const& name = rheology_names()[static_cast<std::size_t>(law.model)];
        // All of these laws rise or fall with the rate throughout.
        auto const [thin, thick] = std::minmax({law.viscosity_at(0), law.viscosity_at(seen_at_most)});
        with_every_sweep(law, [&, thin = thin, thick = thick](std::vector<double> const& mus) {
            for (double const mu : mus) {
                EXPECT_GE(mu, thin * (1 - 1e-15)) << name;
                EXPECT_LE(mu, thick * (1 + 1e-15)) << name;
            }
        });
    }
}

TEST(RigidRotation, SwellsInHalfAStepOfTheProjection) {
    // Positions half a step s on under velocities of its start: v = Omega (I + s Omega)^-1 x has the symmetric part
    // s omega^2/(1 + s^2 omega^2) across the axis. That is an expansion in 2D, a shear rate of sqrt(4/3) as much in 3D.
    double const step = 1e-3 / omega, s = step / 2, swelling = s * omega * omega / (1 + s * s * omega * omega);
    for (bool const implicit : {false, true}) {
        for (double const g : seen_by_projection<2>(shown, implicit, step)) EXPECT_LE(g, seen_at_most);
        for (double const g : seen_by_projection<3>(shown, implicit, step))
            EXPECT_NEAR(g, std::sqrt(4.0 / 3) * swelling, seen_at_most);
    }
}

}  // namespace coronet
