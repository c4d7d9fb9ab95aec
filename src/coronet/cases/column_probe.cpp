// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/column_probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/column_mode.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/growth_fit.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

constexpr double least_growth = 2, largest_wave = 0.1;  // of what is fitted: over the first amplitude, and a

}  // namespace

ColumnProbe::ColumnProbe(ProbeKeys const& keys, Case const& c)
    : case_(c), length_(c.domain.size[0]), k_(2 * pi * keys.waves / length_), ledger_(c) {}

std::vector<std::string> ColumnProbe::columns() const {
    std::vector<std::string> names{"wave_amplitude", "neck_radius"};
    ledger_.add_columns(names);
    return names;
}

std::vector<double> ColumnProbe::sample(Snapshot<3> const& now) {
    auto const total = totals(now.particles);
    if (time_.empty()) {
        mass_ = total.mass;
        momentum_ = total.momentum;
        radius_ = std::sqrt(total.volume / (pi * length_));
        density_ = mass_ / total.volume;  // under the pressure of tension
    }
    momentum_drift_ = std::max(momentum_drift_, std::sqrt(norm2(total.momentum - momentum_)));
    time_.push_back(now.time);
    amplitude_.push_back(amplitude_of(now.particles));
    double const neck = neck_of(now.particles);
    if (neck == 0 && !broken_) broken_ = now.time;
    std::vector<double> row{amplitude_.back(), neck / radius_};
    ledger_.sample(now, row);
    return row;
}

double ColumnProbe::amplitude_of(Particles<3> const& particles) const {
    auto const view = particles.view();
    auto const centre = totals(particles).centre();
    auto const moment = sum_over(particles.owned(), std::complex<double>{}, [&](std::size_t i) {
        auto const x = view.get<Position>(i) - centre;
        return std::polar(view.get<Mass>(i) * std::cyl_bessel_i(0, k_ * std::hypot(x[1], x[2])), k_ * x[0]);
    });
    return std::abs(moment) / (mass_ * std::cyl_bessel_i(0, k_ * radius_));
}

double ColumnProbe::neck_of(Particles<3> const& particles) const {
    double const reach = 2 * case_.surface.coverage_radius * case_.particles.spacing;
    auto const slices = std::max(std::floor(length_ / reach), 1.0);
    std::vector<double> mass(static_cast<std::size_t>(slices), 0);
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        double const periods = particles.view().get<Position>(i)[0] / length_;
        auto const slice = static_cast<std::size_t>(slices * (periods - std::floor(periods)));
        mass[std::min(slice, mass.size() - 1)] += particles.view().get<Mass>(i);
    }
    return std::sqrt(*std::ranges::min_element(mass) * slices / (density_ * pi * length_));
}

Measure ColumnProbe::growth_rate() const {
    auto const& fluid = case_.fluid;
    double const mu = rheology_of(case_).viscosity_at(0),
                 exact = column_growth_rate(k_, radius_, density_, fluid.surface_tension, mu);
    std::string const theory =
        fmt::format("exact viscous mode of small amplitude on a column, k R = {:.4g}, Ohnesorge number {:.4g}",
                    k_ * radius_, mu / std::sqrt(density_ * fluid.surface_tension * radius_));
    std::vector<double> times, values;
    for (std::size_t n = 0; n < time_.size() && amplitude_[n] <= largest_wave; ++n)
        if (amplitude_[n] >= least_growth * amplitude_[0]) {
            times.push_back(time_[n]);
            values.push_back(amplitude_[n]);
        }
    if (!(k_ * radius_ < 1))
        return {"growth_rate",
                std::numeric_limits<double>::quiet_NaN(),
                {},
                {},
                fmt::format("not fitted: waves shorter than the circumference are stable; k R = {:.4g}", k_ * radius_)};
    auto const fit = fit_growth(times, values, exact);
    if (!fit)
        return {"growth_rate",
                std::numeric_limits<double>::quiet_NaN(),
                exact,
                {},
                fmt::format("not fitted: {} samples between {} times the first amplitude and {}, of which {} are "
                            "needed that grow at a "
                            "third to three times the rate of theory; {}",
                            times.size(), least_growth, largest_wave, least_growth_samples, theory)};
    return {"growth_rate",
            fit->rate,
            exact,
            fit->rate / exact - 1,
            fmt::format("{}; fitted to {} samples from {:.4g} to {:.4g} s; the error is relative", theory, times.size(),
                        times.front(), times.back()),
            fit->rate_error};
}

std::vector<Measure> ColumnProbe::measures() const {
    if (time_.empty()) return {};
    double const speed = std::sqrt(case_.fluid.surface_tension / (density_ * radius_)),
                 drift = momentum_drift_ / (mass_ * speed);
    std::vector<Measure> measures{growth_rate()};
    measures.push_back({"breaks_at",
                        broken_.value_or(std::numeric_limits<double>::quiet_NaN()),
                        {},
                        {},
                        broken_ ? "the first sample with a slice that holds nothing [s]" : "it has not broken"});
    std::string const over = "largest of all samples, over mass times sqrt(sigma/(rho R))";
    if (no_outer_force(case_)) measures.push_back({"momentum_drift", drift, 0.0, drift, "conservation; " + over});
    else measures.push_back({"momentum_drift", drift, {}, {}, "by the outer force, too; " + over});
    ledger_.add_measures(measures);
    return measures;
}

}  // namespace coronet
