// SPDX-License-Identifier: BSD-3-Clause

// The steps of the weakly compressible scheme, and how long they may be.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coronet/core/error.hpp"
#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

template <int D>
void WeaklyCompressible<D>::advance(double time, double step) {
    if (settings_.stepping == Stepping::symplectic_euler) symplectic_step(time, step);
    else predict_and_correct(time, step);
    if (shifting_.active()) phases_.act("shift", [&] { shifting_.apply(particles_); });
}

template <int D>
void WeaklyCompressible<D>::symplectic_step(double time, double step) {
    evaluate(time, step, step);
    // A force changes the kinetic energy by its impulse times the mean of the velocities before and after the step.
    if (settings_.surface.acts_on_boundary()) works_ = works_ + step * rates_of_work(0.5 * step);
    if (conserving_shift_) phases_.act("shift", [&] { conserving_shift_->find(particles_, neighbours_); });
    auto const view = particles_.view();
    phases_.act("move", [&] {
        for_each(particles_.owned(), [&](std::size_t i) {
            auto const v = view.template get<Velocity>(i) + step * view.template get<Acceleration>(i);
            view.template set<Velocity>(i, v);
            view.template set<Position>(i, view.template get<Position>(i) + step * v);
            view.template at<Density>()[i] += step * view.template at<DensityRate>()[i];
        });
    });
    if (settings_.surface.acts_on_boundary()) {
        last_way_ = {step, content_rates()};
        for (double& gain : last_way_.gain) gain *= step;
    }
    if (conserving_shift_) phases_.act("shift", [&] { conserving_shift_->apply(particles_, neighbours_, boundary_); });
}

template <int D>
void WeaklyCompressible<D>::predict_and_correct(double time, double step) {
    damp(0.5 * step);
    auto const view = particles_.view();
    phases_.act("predict", [&] {
        for_each(particles_.owned(), [&](std::size_t i) {
            auto const x = view.template get<Position>(i);
            auto const v = view.template get<Velocity>(i);
            double const rho = view.template get<Density>(i);
            view.template set<PositionBefore>(i, x);
            view.template set<VelocityBefore>(i, v);
            view.template set<DensityBefore>(i, rho);
            view.template set<Position>(i, x + 0.5 * step * v);
            view.template set<Velocity>(i, v + 0.5 * step * view.template get<Acceleration>(i));
            view.template set<Density>(i, rho + 0.5 * step * view.template get<DensityRate>(i));
        });
    });
    evaluate(time + 0.5 * step, 0, step);
    damp(step);
    if (settings_.surface.acts_on_boundary()) works_ = works_ + step * rates_of_work(0);
    if (conserving_shift_) phases_.act("shift", [&] { conserving_shift_->find(particles_, neighbours_); });
    phases_.act("correct", [&] {
        bool const mean = settings_.position_update == PositionUpdate::mean_velocity;
        for_each(particles_.owned(), [&](std::size_t i) {
            auto const v0 = view.template get<VelocityBefore>(i);
            auto const v = v0 + step * view.template get<Acceleration>(i);
            auto const drift = mean ? 0.5 * (v0 + v) : view.template get<Velocity>(i);
            view.template set<Position>(i, view.template get<PositionBefore>(i) + step * drift);
            view.template set<Velocity>(i, v);
            view.template set<Density>(i,
                                       view.template get<DensityBefore>(i) + step * view.template get<DensityRate>(i));
        });
    });
    if (conserving_shift_) phases_.act("shift", [&] { conserving_shift_->apply(particles_, neighbours_, boundary_); });
}

/// Makes the accelerations fit for a step that viscosity does not limit.
template <int D>
void WeaklyCompressible<D>::damp(double step) {
    if (!implicit_viscosity_) return;
    double const before = power();
    phases_.act("viscous step", [&] {
        auto const& liquid = settings_.liquid;
        auto const mu = particles_.view().template at<Viscosity>();
        viscous_solved_ = implicit_viscosity_->apply(particles_, neighbours_, step, [&](std::size_t i) {
            return liquid.is_newtonian() ? liquid.rheology.viscosity : mu[i];
        });
    });
    if (!viscous_solved_.converged)
        throw RunError(fmt::format(
            "the viscous step did not converge: after {} iterations the residual is {:.2g} of the right-hand side, and "
            "{:.2g} is asked for (method.tolerance), with at most {} iterations (method.most_iterations)",
            viscous_solved_.iterations, viscous_solved_.residual, settings_.solve.tolerance,
            settings_.solve.most_iterations));
    dissipation_ += before - power();
}

/// Of all forces [W].
template <int D>
double WeaklyCompressible<D>::power() const {
    auto const view = particles_.view();
    return sum_over(particles_.owned(), 0.0, [&](std::size_t i) {
        return view.template at<Mass>()[i] * dot(view.template get<Acceleration>(i), view.template get<Velocity>(i));
    });
}

template <int D>
StepLimit WeaklyCompressible<D>::time_limit() const {
    auto const view = particles_.view();
    std::size_t const n = particles_.owned();
    double const h = settings_.kernel.support / 3;
    struct Largest {
        double c, a2;
    };
    bool const newtonian = settings_.liquid.is_newtonian();
    double const mu = newtonian ? settings_.liquid.rheology.viscosity
                                : max_over(n, 0, [&](std::size_t i) { return view.template at<Viscosity>()[i]; });
    auto const [c, a2] = fold(
        n, Largest{0, 0},
        [&](std::size_t i) {
            return Largest{view.template at<SoundSpeed>()[i], norm2(view.template get<Acceleration>(i))};
        },
        [](Largest const& a, Largest const& b) {
            return Largest{std::max(a.c, b.c), std::max(a.a2, b.a2)};
        });
    double const nu = mu / settings_.equation_of_state.rho0;
    constexpr double never = std::numeric_limits<double>::infinity();

    // Fang et al. (2009) Eqs 90, 91, 92 with safe factors: c is the speed of sound, a the largest force per mass.
    StepLimit limit{settings_.courant * h / c, "sound"};
    auto const vote = [&](double step, std::string_view reason) {
        if (step < limit.step) limit = {step, reason};
    };
    vote(a2 > 0 ? 0.25 * std::sqrt(h / std::sqrt(a2)) : never, "force");
    vote(step_limit(settings_.pair_terms, h, c), "pair terms");
    if (!implicit_viscosity_) vote(nu > 0 ? 0.125 * h * h / nu : never, "viscosity");
    vote(capillary_step(settings_.surface, settings_.equation_of_state.rho0), "capillary waves");
    return limit;
}

template void WeaklyCompressible<2>::advance(double, double);
template StepLimit WeaklyCompressible<2>::time_limit() const;
template void WeaklyCompressible<3>::advance(double, double);
template StepLimit WeaklyCompressible<3>::time_limit() const;

}  // namespace coronet
