// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/mode_probe.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/fluid.hpp"
#include "coronet/cases/oscillation_fit.hpp"
#include "coronet/cases/shapes.hpp"
#include "coronet/cases/solid_harmonic.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

constexpr double least_amplitude = 1e-6;  // of the radius: below, the first amplitude has no phase
constexpr double least_periods = 2;       // that a fit needs
constexpr double least_samples = 10;      // a period

}  // namespace

template <int D>
std::complex<double> ModeProbe<D>::amplitude_of(Snapshot<D> const& now) const {
    if constexpr (D == 2) return mode_of(now.outline().line, n_) / radius_;
    auto const view = now.particles.view();
    auto const centre = totals(now.particles).centre();
    double const turn = case_.shapes.front().rotation;
    double const moment = sum_over(now.particles.owned(), 0.0, [&](std::size_t i) {
        auto const x = turned((1 / radius_) * (view.template get<Position>(i) - centre), -turn);
        return view.template get<Mass>(i) * solid_harmonic(n_, x).value;
    });
    return (2 * n_ + 1) / (4 * std::numbers::pi) * moment / (density_ * std::pow(radius_, 3));
}

template <int D>
std::vector<double> ModeProbe<D>::sample(Snapshot<D> const& now) {
    bool const first = time_.empty();
    double const unit = D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
    if (first) {
        auto const total = totals(now.particles);
        radius_ = std::pow(total.volume / unit, 1.0 / D);
        density_ = total.mass / total.volume;  // under the pressure of tension
    }
    auto const amplitude = amplitude_of(now);
    if (first && std::abs(amplitude) > least_amplitude) phase_ = amplitude / std::abs(amplitude);
    auto const along = amplitude * std::conj(phase_);
    time_.push_back(now.time);
    value_.push_back(along.real());
    shear_.push_back(shear_of(now.particles));
    if (D == 3) return {along.real()};
    return {along.real(), along.imag()};
}

/// sum V mu g^2 and sum V g^2, g the shear rate, which the viscous stress tells: mu g^2 = tau : tau/(2 mu).
template <int D>
typename ModeProbe<D>::Shear ModeProbe<D>::shear_of(Particles<D> const& particles) const {
    Shear sums;
    if (!particles.template has<Viscosity>() || !particles.template has<Stress>()) return sums;
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        auto tau = view.template get<Stress>(i);
        double mean = 0, tau2 = 0;
        for (int k = 0; k < D; ++k) mean += tau(k, k) / D;
        for (int k = 0; k < D; ++k) tau(k, k) -= mean;
        for (int k = 0; k < D; ++k)
            for (int l = 0; l < D; ++l) tau2 += tau(k, l) * tau(k, l) / 2;
        double const mu = view.template get<Viscosity>(i), V = view.template get<Mass>(i) / case_.fluid.density;
        if (mu == 0) continue;
        sums.viscous += V * tau2 / mu;
        sums.squared += V * tau2 / (mu * mu);
    }
    return sums;
}

/// Of the samples from a time on.
template <int D>
double ModeProbe<D>::viscosity_of_the_flow(double from) const {
    Shear sums;
    for (std::size_t k = 0; k < time_.size(); ++k)
        if (time_[k] >= from) sums.viscous += shear_[k].viscous, sums.squared += shear_[k].squared;
    return sums.squared > 0 ? sums.viscous / sums.squared : rheology_of(case_).viscosity_at(0);
}

template <int D>
std::vector<Measure> ModeProbe<D>::measures() const {
    if (time_.empty()) return {};
    auto const& fluid = case_.fluid;
    auto const inviscid = drop_mode(D, n_, radius_, density_, fluid.surface_tension, 0);
    double const mu = viscosity_of_the_flow(time_.front() + 2 * std::numbers::pi / inviscid->angular_frequency);
    std::string const liquid =
        fluid.rheology == "newtonian" ? "" : fmt::format(", with the viscosity {:.4g} Pa s that dissipated", mu);
    std::string const theory = fmt::format("exact viscous mode {} of small amplitude in {}D, Ohnesorge number {:.4g}{}",
                                           n_, D, mu / std::sqrt(density_ * fluid.surface_tension * radius_), liquid);
    auto const exact = drop_mode(D, n_, radius_, density_, fluid.surface_tension, mu);
    double const none = std::numeric_limits<double>::quiet_NaN();
    if (!exact) {
        std::string const why = "not fitted: it does not oscillate; " + theory;
        return {{"period", none, {}, {}, why}, {"damping_rate", none, {}, {}, why}};
    }
    double const period = 2 * std::numbers::pi / exact->angular_frequency;
    std::vector<double> times, values;
    for (std::size_t k = 0; k < time_.size(); ++k)
        if (time_[k] >= time_.front() + period) {
            times.push_back(time_[k]);
            values.push_back(value_[k]);
        }
    double const periods = times.empty() ? 0 : (times.back() - times.front()) / period;
    bool const enough = periods >= least_periods && static_cast<double>(times.size()) >= least_samples * periods;
    auto const fit = enough ? fit_oscillation(times, values, exact->angular_frequency) : std::nullopt;
    if (!fit) {
        std::string const why = fmt::format(
            "not fitted: the run has {:.3g} periods after the first and {} samples in them, {} and {} a period are "
            "needed; {}",
            periods, times.size(), least_periods, least_samples, theory);
        return {{"period", none, period, {}, why}, {"damping_rate", none, exact->damping, {}, why}};
    }
    double const found = 2 * std::numbers::pi / fit->angular_frequency;
    std::string const window = fmt::format("{}; fitted to {} samples from {:.4g} to {:.4g} s; the error is relative",
                                           theory, times.size(), times.front(), times.back());
    std::optional<double> damping_error;
    if (exact->damping > 0) damping_error = fit->damping / exact->damping - 1;
    return {{"period", found, period, found / period - 1, window,
             found * fit->angular_frequency_error / fit->angular_frequency},
            {"damping_rate", fit->damping, exact->damping, damping_error, window, fit->damping_error}};
}

template class ModeProbe<2>;
template class ModeProbe<3>;

}  // namespace coronet
