// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/weakly_compressible.hpp"

#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/arrangement.hpp"
#include "coronet/schemes/check_state.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/schemes/stress_close.hpp"
#include "coronet/schemes/wall_forces.hpp"

namespace coronet {

namespace {

// Of a skin that is tuned: where it begins, as a share of the support, and the cost of a listing in evaluations
// (docs/performance.md).
constexpr double first_skin = 0.03, listing_cost = 0.8;

}  // namespace

template <int D>
WeaklyCompressible<D>::WeaklyCompressible(Settings const& settings, Particles<D> particles)
    : settings_(settings),
      particles_(std::move(particles)),
      neighbours_(settings.kernel.support, settings.skin > 0 ? settings.skin : first_skin * settings.kernel.support,
                  settings.skin > 0 ? 0 : listing_cost, settings.box),
      walls_({settings.wall_motion, settings.body_force, settings.gravity, settings.equation_of_state, settings.liquid,
              settings.kernel, settings.precision, settings.lattice_slope_moment, settings.wall_contact}),
      shifting_(settings.shifting, settings.kernel, settings.precision) {
    if (settings.implicit_viscosity) implicit_viscosity_.emplace(settings.kernel, settings.solve);
    if (settings.shift_range > 0) conserving_shift_.emplace(settings.shift_range);
    particles_.allocate(Fields<Position, Velocity, Density, Mass, Volume, Pressure, SoundSpeed, Acceleration,
                               DensityRate, PositionBefore, VelocityBefore, DensityBefore>{});
    bool const is_symplectic = settings_.stepping == Stepping::symplectic_euler;
    if (!corrected_morris() && (!one_sweep() || is_symplectic)) particles_.allocate(Fields<Stress>{});
    if (!settings_.liquid.is_newtonian() || corrected_between()) particles_.allocate(Fields<Viscosity>{});
    if (corrected_morris()) particles_.allocate(Fields<SlopeCorrection, ValueCorrection, FellBack>{});
    else if (settings_.gradient != Gradient::sph)
        particles_.allocate(Fields<CorrectedStress, StressOffset, OwnAcceleration, FellBack>{});
    if (settings_.gradient == Gradient::cph) particles_.allocate(Fields<Surface, Exterior>{});
    update_state();
    auto const view = particles_.view();
    for_each(particles_.owned(), [&](std::size_t i) {  // what the first symplectic step is bounded by
        view.template set<Acceleration>(i, settings_.gravity);
        if (particles_.template has<Viscosity>())
            view.template at<Viscosity>()[i] = settings_.liquid.rheology.largest_viscosity();
    });
}

template <int D>
template <class... Parts>
void WeaklyCompressible<D>::sweep_parts(Parts const&... parts) {
    sweep(particles_, neighbours_, settings_.kernel, settings_.precision, parts...);
}

template <int D>
void WeaklyCompressible<D>::begin_step(double time) {
    if (settings_.stepping == Stepping::symplectic_euler)
        phases_.act("neighbours", [&] {
            walls_.move(particles_, settings_.box, time);
            update_neighbours();
        });
    else evaluate(time);
    phases_.act("check", [&] { check_state(particles_); });
}

template <int D>
std::vector<Reading> WeaklyCompressible<D>::readings() const {
    std::vector<Reading> list{{"singular_matrices", static_cast<double>(counters_.singular_now)}};
    if (implicit_viscosity_) list.push_back({"viscous_iterations", static_cast<double>(viscous_solved_.iterations)});
    constexpr char const* names[] = {"wall_force_x", "wall_force_y", "wall_force_z"};
    if (particles_.count(Role::wall) > 0)
        for (int k = 0; k < D; ++k) list.push_back({names[k], wall_force_[k]});
    if (!settings_.surface.acts_on_boundary()) return list;
    add_readings(list, boundary_, find_boundary_.jumps(), settings_.surface.tension, works_);
    auto const view = particles_.view();
    list.push_back({"compressive_energy", sum_over(particles_.owned(), 0.0, [&](std::size_t i) {
                        return view.template at<Mass>()[i] *
                               settings_.equation_of_state.energy(view.template at<Density>()[i]);
                    })});
    return list;
}

template <int D>
void WeaklyCompressible<D>::evaluate(double time, double dt, double shift) {
    bool const shifts = shifting_.active() && shift > 0;
    phases_.act("neighbours", [&] {
        walls_.move(particles_, settings_.box, time);
        update_neighbours();
    });
    phases_.act("state", [&] { update_state(); });
    if (particles_.size() > particles_.owned()) phases_.act("walls", [&] { update_surroundings(); });
    bool const on_boundary = settings_.surface.acts_on_boundary();
    if (on_boundary) phases_.act("surface", [&] { find_boundary_and_mean_pressure(dt); });
    // What pressure the density will have must be known before the forces: then one sweep is not enough.
    bool const at_walls = particles_.count(Role::wall) > 0, ahead = dt > 0;
    if (!one_sweep() || ahead) {
        phases_.act("gradients", [&] { gradients_and_stress(at_walls ? 0 : dt, shifts ? shift : 0); });
        count_singular();
    }
    if (shifts && settings_.gradient != Gradient::fpm)
        phases_.act("shift", [&] { shifting_.find(particles_, neighbours_, shift, &walls_); });
    if (ahead && particles_.size() > particles_.owned()) phases_.act("walls", [&] { look_ahead(dt); });
    if (one_sweep()) phases_.act("rates", [&] { rates_in_one_sweep(); });
    else phases_.act("forces", [&] { forces(); });
    if (at_walls)
        phases_.act("walls", [&] {
            if (one_sweep() || !ahead) walls_.add_to_density_rate(particles_, neighbours_);
            walls_.add_contact(particles_);
        });
    if (on_boundary)
        phases_.act("surface", [&] {
            look_at_dissipation();
            act_on_boundary(dt);
        });
    else if (settings_.surface.tension > 0)
        phases_.act("surface", [&] {
            find_surface(particles_, neighbours_, settings_.surface);
            add_tension(particles_, settings_.surface);
        });
    if (settings_.body_force)
        phases_.act("body force", [&] { settings_.body_force(time, particles_.view(), 0, particles_.owned()); });
    ++counters_.evaluations;
}

template <int D>
void WeaklyCompressible<D>::update_neighbours() {
    if (!neighbours_.update(particles_)) return;
    ++counters_.listings;
    walls_.follow(particles_, neighbours_);
    if (settings_.gradient == Gradient::cph) zones_.mark(particles_, neighbours_);
}

template <int D>
void WeaklyCompressible<D>::update_state() {
    auto const view = particles_.view();
    EquationOfState const eos = settings_.equation_of_state;
    for_each(particles_.owned(), [&](std::size_t i) {
        double const rho = view.template at<Density>()[i];
        view.template at<Pressure>()[i] = eos.pressure(rho);
        view.template at<SoundSpeed>()[i] = eos.sound_speed(rho);
        view.template at<Volume>()[i] = view.template at<Mass>()[i] / rho;
    });
}

/// What liquid sees beyond its own kind, up to date for the first sweep.
template <int D>
void WeaklyCompressible<D>::update_surroundings() {
    auto const& images = neighbours_.images();
    images.refresh(particles_, Fields<Velocity, Volume, Pressure, Density, SoundSpeed>{});
    if (particles_.count(Role::wall) == 0) return;
    walls_.look_at_liquid(particles_, neighbours_);
    images.refresh(particles_, Fields<Velocity, Volume, Pressure, Density, SoundSpeed, WallVelocity, ToMirror, Slip>{});
}

/// With symplectic steps: the pressure at the end of the step for what liquid sees beyond its own kind; near walls, for
/// the liquid, too, whose rate of density now becomes whole.
template <int D>
void WeaklyCompressible<D>::look_ahead(double dt) {
    if (particles_.count(Role::wall) > 0) {
        walls_.add_to_density_rate(particles_, neighbours_);
        auto const view = particles_.view();
        for_each(particles_.owned(), [&](std::size_t i) {
            double const c = view.template at<SoundSpeed>()[i];
            view.template at<Pressure>()[i] += dt * c * c * view.template at<DensityRate>()[i];
        });
    }
    update_surroundings();
}

template <int D>
void WeaklyCompressible<D>::gradients_and_stress(double dt, double shift) {
    CorrectedClose const corrected{settings_.liquid, settings_.kernel.at_zero(), true, dt,
                                   settings_.central_viscosity.share};
    CorrectionClose const correction{corrected.kernel_at_zero, dt};
    auto const gradients_ending = [&](auto const& close) {
        if (shift > 0) shifting_.find(particles_, neighbours_, shift, &walls_, close);
        else sweep_parts(Part{neighbours_.all(), CorrectedGradients{}, close});
    };
    PlainClose const plain{settings_.liquid, dt};
    switch (settings_.gradient) {
        case Gradient::sph: sweep_parts(Part{neighbours_.all(), PlainGradients{}, plain}); return;
        case Gradient::fpm:
            if (corrected_morris()) gradients_ending(correction);
            else gradients_ending(corrected);
            break;
        case Gradient::cph:
            sweep_parts(Part{zones_.exterior, CorrectedGradients{}, corrected},
                        Part{zones_.border, PlainGradientsAndSums{}, NearClose<true>{plain}},
                        Part{zones_.near, PlainGradients{}, NearClose<false>{plain}},
                        Part{zones_.deep, PlainGradients{}, plain});
            break;
    }
}

template <int D>
void WeaklyCompressible<D>::count_singular() {
    if (settings_.gradient == Gradient::sph) return;
    double const* const fell_back = particles_.view().template at<FellBack>();
    counters_.singular_now =
        static_cast<std::int64_t>(sum_over(particles_.owned(), 0.0, [&](std::size_t i) { return fell_back[i]; }));
    counters_.singular_matrices += counters_.singular_now;
}

/// Of what the gradient sweep gave, for the force sweep.
template <int D>
void WeaklyCompressible<D>::refresh_images() {
    auto const& images = neighbours_.images();
    if (variable_morris()) images.refresh(particles_, Fields<Viscosity>{});
    else if (corrected_morris()) images.refresh(particles_, Fields<SlopeCorrection, ValueCorrection>{});
    else if (settings_.gradient == Gradient::sph) images.refresh(particles_, Fields<Stress>{});
    else images.refresh(particles_, Fields<CorrectedStress, StressOffset>{});
    if (corrected_between()) images.refresh(particles_, Fields<Viscosity>{});
}

template <int D>
void WeaklyCompressible<D>::forces() {
    refresh_images();
    if (variable_morris()) {
        return sweep_parts(Part{neighbours_.all(), PressureAndVariableMorris{{}, {}, settings_.pair_terms},
                                PlainForceClose<D>{settings_.gravity}});
    }
    PlainForceClose<D> const plain_close{settings_.gravity};
    CorrectedForceClose<D> const corrected_close{settings_.gravity};
    auto const forces_of = [&](auto const& plain, auto const& corrected) {
        switch (settings_.gradient) {
            case Gradient::sph: return sweep_parts(Part{neighbours_.all(), plain, plain_close});
            case Gradient::fpm: return sweep_parts(Part{neighbours_.all(), corrected, corrected_close});
            case Gradient::cph:
                return sweep_parts(Part{zones_.corrected, corrected, corrected_close},
                                   Part{zones_.plain, plain, plain_close});
        }
    };
    auto const& terms = settings_.pair_terms;
    if (corrected_morris()) {
        CorrectedMorrisViscosity const viscosity{settings_.liquid.rheology.viscosity};
        return sweep_parts(Part{neighbours_.all(), CorrectedPressureAndMorris{{}, viscosity, terms}, plain_close});
    }
    auto const& central = settings_.central_viscosity;
    if (central.active() || any_active(terms))
        forces_of(PlainForcesAndPairTerms{{}, terms}, CorrectedForcesAndPairTerms{{}, central, terms});
    else forces_of(PlainForces{}, CorrectedForces{});
}

/// Whether no stress is needed: plain gradients, and no viscosity or one that acts between velocities.
template <int D>
bool WeaklyCompressible<D>::one_sweep() const {
    return settings_.gradient == Gradient::sph &&
           (settings_.liquid.is_inviscid() ||
            (settings_.viscous_force == ViscousForce::morris && settings_.liquid.is_newtonian()));
}

/// Whether viscosity acts between velocities, and is a matter of the shear rate.
template <int D>
bool WeaklyCompressible<D>::variable_morris() const {
    return settings_.viscous_force == ViscousForce::morris && !settings_.liquid.is_newtonian();
}

/// The conservative equations of Jahanbakhsh et al. (2012), 15, 18 and 19.
template <int D>
bool WeaklyCompressible<D>::corrected_morris() const {
    return settings_.gradient == Gradient::fpm && settings_.viscous_force == ViscousForce::morris;
}

/// Whether the law of corrected forces and pair terms is swept: for walls it is in any case.
template <int D>
bool WeaklyCompressible<D>::corrected_between() const {
    return settings_.gradient != Gradient::sph && !corrected_morris() &&
           (settings_.central_viscosity.active() || any_active(settings_.pair_terms) ||
            particles_.count(Role::wall) > 0);
}

template <int D>
void WeaklyCompressible<D>::rates_in_one_sweep() {
    PlainRatesClose<D> const close{settings_.gravity};
    MorrisViscosity const viscosity{settings_.liquid.rheology.viscosity};
    auto const rates_of = [&](auto const& law) { sweep_parts(Part{neighbours_.all(), law, close}); };
    if (any_active(settings_.pair_terms)) rates_of(PlainSweepAndPairTerms{{}, viscosity, {}, settings_.pair_terms});
    else rates_of(PlainSweep{{}, viscosity, {}});
}

template <int D>
void WeaklyCompressible<D>::refresh() {
    update_state();
    if (particles_.size() > particles_.owned())  // probes look beyond the faces, too
        neighbours_.images().refresh(particles_, Fields<Velocity, Volume, Pressure, Density>{});
    if (particles_.count(Role::wall) == 0) return;
    if (settings_.stepping == Stepping::symplectic_euler) {  // what was evaluated last is a step old
        update_surroundings();
        if (!one_sweep()) {
            gradients_and_stress(0);
            refresh_images();
        }
    }
    find_wall_forces(particles_, neighbours_, settings_);
    auto const view = particles_.view();
    wall_force_ = sum_over(particles_.count(Role::wall), Vector<double, D>{}, [&](std::size_t k) {
        return view.template get<WallForce>(particles_.begin(Role::wall) + k);
    });
}

template <int D>
Arrangement WeaklyCompressible<D>::arrangement() {
    update_neighbours();
    if (settings_.stepping == Stepping::symplectic_euler && settings_.surface.acts_on_boundary())  // a step old
        boundary_ = find_boundary_(particles_, neighbours_, settings_.surface);
    return arrangement_of(particles_, neighbours_);
}

template class WeaklyCompressible<2>;
template class WeaklyCompressible<3>;

}  // namespace coronet
