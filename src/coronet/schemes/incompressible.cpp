// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/incompressible.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coronet/core/error.hpp"
#include "coronet/pairs/sweep.hpp"
#include "coronet/schemes/arrangement.hpp"
#include "coronet/schemes/check_state.hpp"
#include "coronet/schemes/laws.hpp"
#include "coronet/schemes/stress_close.hpp"

namespace coronet {

namespace {

constexpr double first_skin = 0.03, listing_cost = 0.8;  // as in the weakly compressible scheme

void expect_convergence(std::string_view what, std::string_view where, Solved const& solved,
                        SolveLimits const& limits) {
    if (solved.converged) return;
    std::string const reached = fmt::format("after {} iterations{} the residual is {:.2g} of the right-hand side",
                                            solved.iterations, where, solved.residual);
    if (solved.broke_down)
        throw RunError(
            fmt::format("the equation of the {} broke down: it is not positive definite, or a number is not "
                        "finite; {} (more iterations do not help, a shorter step may: time.step)",
                        what, reached));
    throw RunError(
        fmt::format("the {} did not converge: {}, and {:.2g} is asked for (method.tolerance), with at most "
                    "{} iterations a solve (method.most_iterations)",
                    what, reached, limits.tolerance, limits.most_iterations));
}

}  // namespace

template <int D>
Incompressible<D>::Incompressible(Settings const& settings, Particles<D> particles)
    : settings_(settings),
      particles_(std::move(particles)),
      neighbours_(settings.kernel.support, settings.skin > 0 ? settings.skin : first_skin * settings.kernel.support,
                  settings.skin > 0 ? 0 : listing_cost),
      shifting_(settings.shifting, settings.kernel, Precision::full),
      projection_(
          [&]() -> std::unique_ptr<PressureOperator<D>> {
              std::unique_ptr<PressureOperator<D>> pressure;
              if (settings.pressure == Operator::consistent) {
                  pressure = std::make_unique<ConsistentPressure<D>>(settings.pressure_kernel, GradientKind::corrected,
                                                                     settings.compact_share);
              } else {
                  auto thesis = std::make_unique<ThesisPressure<D>>(settings.pressure_kernel, settings.thesis);
                  thesis_ = thesis.get();
                  pressure = std::move(thesis);
              }
              // A pressure that is zero at the surface particles has no mean to act there.
              if (!settings.surface.acts_on_boundary() || (thesis_ && settings.thesis.surface == SurfacePressure::zero))
                  return pressure;
              auto on_boundary = std::make_unique<MeanOnBoundary<D>>(std::move(pressure));
              on_boundary_ = on_boundary.get();
              return on_boundary;
          }(),
          settings.preconditioning, settings.surface.spacing, settings.solve) {
    particles_.allocate(Fields<Position, Velocity, Density, Mass, Volume, Pressure, Acceleration, PositionBefore,
                               VelocityBefore, Surface, Stress>{});
    bool const is_viscous = !settings_.liquid.is_inviscid();
    bool const implicit = settings_.viscous_step == Viscous::implicit_step;
    bool const between = settings_.central_viscosity.active() || any_active(settings_.pair_terms);
    if (!settings_.liquid.is_newtonian() || between) particles_.allocate(Fields<Viscosity>{});
    if (is_viscous && implicit) viscous_step_.emplace(settings_.kernel, settings_.liquid, settings_.solve);
    if (is_viscous && !implicit)
        particles_.allocate(Fields<DensityRate, CorrectedStress, StressOffset, OwnAcceleration, FellBack>{});
    if (between) particles_.allocate(Fields<SoundSpeed>{});
    if (settings_.shift_range > 0) shift_.emplace(settings_.shift_range);
    auto const view = particles_.view();
    for_each(particles_.size(), [&](std::size_t i) {
        view.template at<Density>()[i] = settings_.density;
        view.template at<Volume>()[i] = view.template at<Mass>()[i] / settings_.density;
        view.template set<Acceleration>(i, settings_.gravity);  // what the first step is bounded by
        if (between) view.template at<SoundSpeed>()[i] = settings_.sound_speed;
        if (particles_.template has<Viscosity>())  // until the shear rate is known, for the first step
            view.template at<Viscosity>()[i] = settings_.liquid.rheology.largest_viscosity();
    });
}

template <int D>
bool Incompressible<D>::needs_surface() const {
    return (has_tension() && !settings_.surface.acts_on_boundary()) ||
           (thesis_ && settings_.thesis.surface != SurfacePressure::free);
}

template <int D>
void Incompressible<D>::begin_step(double /*time*/) {
    phases_.act("neighbours", [&] { counters_.listings += neighbours_.update(particles_); });
    phases_.act("check", [&] { check_state(particles_); });
}

template <int D>
StepLimit Incompressible<D>::time_limit() const {
    auto const view = particles_.view();
    std::size_t const n = particles_.owned();
    double const h = settings_.kernel.support / 3, rho = settings_.density;
    auto const mean = (1 / static_cast<double>(n)) *
                      sum_over(n, Vector<double, D>{}, [&](std::size_t i) { return view.template get<Velocity>(i); });
    double const v =
        std::sqrt(max_over(n, 0, [&](std::size_t i) { return norm2(view.template get<Velocity>(i) - mean); }));
    double const a =
        std::sqrt(max_over(n, 0, [&](std::size_t i) { return norm2(view.template get<Acceleration>(i)); }));
    double const mu = settings_.liquid.is_newtonian()
                          ? settings_.liquid.rheology.viscosity
                          : max_over(n, 0, [&](std::size_t i) { return view.template at<Viscosity>()[i]; });
    constexpr double never = std::numeric_limits<double>::infinity();

    StepLimit limit{v > 0 ? settings_.courant * h / v : never, "speed"};
    auto const vote = [&](double step, std::string_view reason) {
        if (step < limit.step) limit = {step, reason};
    };
    vote(a > 0 ? 0.25 * std::sqrt(h / a) : never, "force");
    vote(step_limit(settings_.pair_terms, h, settings_.sound_speed), "pair terms");
    if (!viscous_step_) vote(mu > 0 ? 0.125 * h * h * rho / mu : never, "viscosity");
    vote(capillary_step(settings_.surface, rho), "capillary waves");
    return limit;
}

template <int D>
void Incompressible<D>::advance(double time, double step) {
    auto const view = particles_.view();
    std::size_t const n = particles_.owned();
    counters_.singular_now = 0;
    phases_.act("predict", [&] {
        for_each(n, [&](std::size_t i) {
            auto const x = view.template get<Position>(i);
            auto const v = view.template get<Velocity>(i);
            view.template set<PositionBefore>(i, x);
            view.template set<VelocityBefore>(i, v);
            view.template set<Position>(i, x + 0.5 * step * v);
        });
    });
    phases_.act("neighbours", [&] { counters_.listings += neighbours_.update(particles_); });
    if (needs_surface()) phases_.act("surface", [&] { look_at_surface(); });
    if (shifting_.active()) phases_.act("shift", [&] { shifting_.find(particles_, neighbours_, step); });
    forces(time + 0.5 * step);
    if (has_tension()) phases_.act("surface", [&] { tension(); });
    push(step);
    if (shift_) phases_.act("shift", [&] { shift_->find(particles_, neighbours_); });
    project(step);
    if (settings_.surface.acts_on_boundary()) add_works(step);
    phases_.act("stress", [&] { set_stress(); });
    phases_.act("correct", [&] {
        for_each(n, [&](std::size_t i) {
            auto const v0 = view.template get<VelocityBefore>(i);
            auto const v = view.template get<Velocity>(i);
            view.template set<Position>(i, view.template get<PositionBefore>(i) + 0.5 * step * (v0 + v));
            view.template set<Acceleration>(i, (1 / step) * (v - v0));
        });
    });
    if (shift_) phases_.act("shift", [&] { shift_->apply(particles_, neighbours_, boundary_); });
    if (shifting_.active()) phases_.act("shift", [&] { shifting_.apply(particles_); });
    ++counters_.evaluations;
}

template <int D>
void Incompressible<D>::look_at_surface() {
    find_surface(particles_, neighbours_, settings_.surface);
    if (!thesis_) return;
    auto const view = particles_.view();
    std::vector<Vector<double, D>> normals(particles_.size());
    for_each(normals.size(), [&](std::size_t i) { normals[i] = view.template get<SurfaceNormal>(i); });
    thesis_->set_normals(std::move(normals));
}

template <int D>
void Incompressible<D>::tension() {
    if (settings_.surface.acts_on_boundary()) {
        boundary_ = find_boundary_(particles_, neighbours_, settings_.surface);
        if (on_boundary_) on_boundary_->set_boundary(boundary_);
        return add_tension(particles_, boundary_, settings_.surface.tension);
    }
    add_tension(particles_, settings_.surface);
}

/// Sets Acceleration to that of every force but pressure, surface tension and an implicit viscous stress.
template <int D>
void Incompressible<D>::forces(double time) {
    auto const view = particles_.view();
    bool const viscous = !settings_.liquid.is_inviscid() && !viscous_step_;
    auto const sweep_of = [&](auto const& part) {
        sweep(particles_, neighbours_, settings_.kernel, Precision::full, part);
    };
    auto const& central = settings_.central_viscosity;
    if (viscous) {
        phases_.act("gradients", [&] {
            sweep_of(Part{neighbours_.all(), CorrectedGradients{},
                          CorrectedClose{settings_.liquid, settings_.kernel.at_zero(), false, 0, central.share}});
        });
        counters_.singular_now = static_cast<std::int64_t>(
            sum_over(particles_.owned(), 0.0, [&](std::size_t i) { return view.template at<FellBack>()[i]; }));
        counters_.singular_matrices += counters_.singular_now;
    }
    phases_.act("forces", [&] {
        auto const& terms = settings_.pair_terms;
        CorrectedForceClose<D> const close{settings_.gravity};
        bool const stressed = viscous && central.share < 1, between = central.active() || any_active(terms);
        if (stressed && between)
            sweep_of(Part{neighbours_.all(), CorrectedForcesAndPairTerms{{}, central, terms}, close});
        else if (stressed) sweep_of(Part{neighbours_.all(), CorrectedForces{}, close});
        else if (between)
            sweep_of(Part{neighbours_.all(), BetweenParticles{central, terms}, PlainForceClose<D>{settings_.gravity}});
        else
            for_each(particles_.owned(), [&](std::size_t i) { view.template set<Acceleration>(i, settings_.gravity); });
    });
    if (settings_.surface.acts_on_boundary()) {
        resistance_.resize(particles_.size());
        for_each(resistance_.size(),
                 [&](std::size_t i) { resistance_[i] = view.template get<Acceleration>(i) - settings_.gravity; });
    }
    if (settings_.body_force)
        phases_.act("body force", [&] { settings_.body_force(time, view, 0, particles_.owned()); });
}

/// From v to v*.
template <int D>
void Incompressible<D>::push(double step) {
    auto const view = particles_.view();
    if (!viscous_step_) {
        phases_.act("predict", [&] {
            for_each(particles_.size(), [&](std::size_t i) {
                view.template set<Velocity>(i,
                                            view.template get<Velocity>(i) + step * view.template get<Acceleration>(i));
            });
        });
        return;
    }
    phases_.act("viscous step", [&] { viscous_solved_ = viscous_step_->advance(particles_, neighbours_, step); });
    for_each(resistance_.size(), [&](std::size_t i) {
        auto const change = view.template get<Velocity>(i) - view.template get<VelocityBefore>(i);
        resistance_[i] += (1 / step) * change - view.template get<Acceleration>(i);
    });
    auto const& viscous = viscous_step_->viscous();
    counters_.singular_now = static_cast<std::int64_t>(viscous.singular_matrices());
    counters_.singular_matrices += counters_.singular_now;
    if (!settings_.liquid.is_newtonian())
        std::copy(viscous.viscosity().begin(), viscous.viscosity().end(), view.template at<Viscosity>());
    expect_convergence("viscous step", " in its two solves", viscous_solved_, settings_.solve);
}

template <int D>
void Incompressible<D>::project(double step) {
    solved_ = projection_.project(particles_, neighbours_, step, phases_);
    phases_.act("pressure solve", [&] { divergence_ = projection_.largest_divergence(particles_); });
    auto const singular = static_cast<std::int64_t>(projection_.pressure().singular_matrices());
    counters_.singular_now += singular;
    counters_.singular_matrices += singular;
    expect_convergence("pressure", "", solved_, settings_.solve);
}

/// A force changes the kinetic energy by its impulse times the mean of the velocities before and after the step.
template <int D>
void Incompressible<D>::add_works(double step) {
    auto const view = particles_.view();
    works_ = works_ + sum_over(particles_.owned(), Works{}, [&](std::size_t i) {
                 auto const way = 0.5 * step * (view.template get<VelocityBefore>(i) + view.template get<Velocity>(i));
                 return Works{-settings_.surface.tension * dot(boundary_.of_size[i], way),
                              -view.template at<Mass>()[i] * dot(resistance_[i], way)};
             });
}

/// The explicit sweep left the viscous part in Stress; the implicit step has it; an inviscid liquid has none.
template <int D>
void Incompressible<D>::set_stress() {
    auto const view = particles_.view();
    bool const swept = !settings_.liquid.is_inviscid() && !viscous_step_;
    for_each(particles_.owned(), [&](std::size_t i) {
        Symmetric<double, D> sigma;
        if (swept) sigma = view.template get<Stress>(i);
        if (viscous_step_) sigma = viscous_step_->stress(i);
        unrolled<D>([&](int k) { sigma(k, k) -= view.template at<Pressure>()[i]; });
        view.template set<Stress>(i, sigma);
    });
}

template <int D>
std::vector<Reading> Incompressible<D>::readings() const {
    std::vector<Reading> list{{"singular_matrices", static_cast<double>(counters_.singular_now)},
                              {"solver_iterations", static_cast<double>(solved_.iterations)},
                              {"divergence_max", divergence_}};
    if (viscous_step_) list.push_back({"viscous_iterations", static_cast<double>(viscous_solved_.iterations)});
    if (settings_.surface.acts_on_boundary())
        add_readings(list, boundary_, find_boundary_.jumps(), settings_.surface.tension, works_);
    return list;
}

template <int D>
Arrangement Incompressible<D>::arrangement() {
    counters_.listings += neighbours_.update(particles_);
    if (settings_.surface.acts_on_boundary())  // steps find it half-way
        boundary_ = find_boundary_(particles_, neighbours_, settings_.surface);
    return arrangement_of(particles_, neighbours_);
}

template class Incompressible<2>;
template class Incompressible<3>;

}  // namespace coronet
