// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/mode_probe.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/fluid.hpp"
#include "coronet/cases/oscillation_fit.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

constexpr double least_amplitude = 1e-6;  // of the radius: below, the first amplitude has no phase
constexpr double least_periods = 2;       // that a fit needs
constexpr double least_samples = 10;      // a period

}  // namespace

std::vector<double> ModeProbe::sample(Snapshot<2> const& now) {
    bool const first = time_.empty();
    if (first) radius_ = std::sqrt(totals(now.particles).mass / (std::numbers::pi * case_.fluid.density));
    auto const amplitude = mode_of(now.outline().line, n_) / radius_;
    if (first && std::abs(amplitude) > least_amplitude) phase_ = amplitude / std::abs(amplitude);
    auto const along = amplitude * std::conj(phase_);
    time_.push_back(now.time);
    value_.push_back(along.real());
    shear_.push_back(shear_of(now.particles));
    return {along.real(), along.imag()};
}

/// sum V mu g^2 and sum V g^2, g the shear rate, which the viscous stress tells: mu g^2 = tau : tau/(2 mu).
ModeProbe::Shear ModeProbe::shear_of(Particles<2> const& particles) const {
    Shear sums;
    if (!particles.has<Viscosity>() || !particles.has<Stress>()) return sums;
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        auto const sigma = view.get<Stress>(i);
        double const half = (sigma(0, 0) - sigma(1, 1)) / 2, tau2 = half * half + sigma(0, 1) * sigma(0, 1);
        double const mu = view.get<Viscosity>(i), V = view.get<Mass>(i) / case_.fluid.density;
        if (mu == 0) continue;
        sums.viscous += V * tau2 / mu;
        sums.squared += V * tau2 / (mu * mu);
    }
    return sums;
}

/// Of the samples from a time on.
double ModeProbe::viscosity_of_the_flow(double from) const {
    Shear sums;
    for (std::size_t k = 0; k < time_.size(); ++k)
        if (time_[k] >= from) sums.viscous += shear_[k].viscous, sums.squared += shear_[k].squared;
    return sums.squared > 0 ? sums.viscous / sums.squared : rheology_of(case_).viscosity_at(0);
}

std::vector<Measure> ModeProbe::measures() const {
    if (time_.empty()) return {};
    auto const& fluid = case_.fluid;
    auto const inviscid = drop_mode(n_, radius_, fluid.density, fluid.surface_tension, 0);
    double const mu = viscosity_of_the_flow(time_.front() + 2 * std::numbers::pi / inviscid->angular_frequency);
    std::string const liquid =
        fluid.rheology == "newtonian" ? "" : fmt::format(", with the viscosity {:.4g} Pa s that dissipated", mu);
    std::string const theory = fmt::format("exact viscous mode {} of small amplitude in 2D, Ohnesorge number {:.4g}{}",
                                           n_, mu / std::sqrt(fluid.density * fluid.surface_tension * radius_), liquid);
    auto const exact = drop_mode(n_, radius_, fluid.density, fluid.surface_tension, mu);
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
        std::string const why =
            fmt::format("not fitted: {} samples over {:.3g} periods after the first, {} and {} a period are needed; {}",
                        times.size(), periods, least_periods, least_samples, theory);
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

}  // namespace coronet
