// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/static_drop_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "coronet/cases/fluid.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

/// Of a round drop of that volume [m].
template <int D>
double radius_of(double volume) {
    return std::pow(volume / (D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3), 1.0 / D);
}

}  // namespace

template <int D>
std::vector<double> StaticDropProbe<D>::sample(Snapshot<D> const& now) {
    auto const total = totals(now.particles);
    if (pressure_.empty()) radius_ = radius_of<D>(total.volume), mass_ = total.mass;
    auto const view = now.particles.view();
    auto const centre = total.centre(), drift = (1 / total.mass) * total.momentum;
    double pressure = 0, volume = 0, fastest2 = 0;
    for (std::size_t i = 0; i < now.particles.owned(); ++i) {
        fastest2 = std::max(fastest2, norm2(view.template get<Velocity>(i) - drift));
        if (norm2(view.template get<Position>(i) - centre) > radius_ * radius_ / 4) continue;
        double const V = view.template get<Mass>(i) / view.template get<Density>(i);
        pressure += V * view.template get<Pressure>(i);
        volume += V;
    }
    pressure_.push_back(volume > 0 ? pressure / volume : 0);
    speed_.push_back(std::sqrt(fastest2));
    volume_.push_back(total.volume);
    return {pressure_.back(), speed_.back()};
}

template <int D>
std::vector<Measure> StaticDropProbe<D>::measures() const {
    if (pressure_.empty()) return {};
    auto const half = static_cast<std::ptrdiff_t>(pressure_.size() / 2);
    auto const mean = [&](std::vector<double> const& all) {
        return std::accumulate(all.begin() + half, all.end(), 0.0) /
               static_cast<double>(all.end() - all.begin() - half);
    };
    double const pressure = mean(pressure_), R = radius_of<D>(mean(volume_)), sigma = case_.fluid.surface_tension,
                 laplace = (D - 1) * sigma / R, mu = rheology_of(case_).viscosity_at(0),
                 capillary = mu * *std::max_element(speed_.begin() + half, speed_.end()) / sigma;
    std::string const when = "over the second half of the samples";
    return {
        {"laplace_pressure", pressure, laplace, pressure / laplace - 1,
         fmt::format("Laplace's {} sigma/R; the mean within half the radius, {}; the error is relative", D - 1, when)},
        {"spurious_capillary_number", capillary, 0.0, capillary,
         fmt::format("a drop at rest; mu v/sigma of the fastest particle, largest {}, Ohnesorge number {:.4g}", when,
                     mu / std::sqrt(mass_ / mean(volume_) * sigma * R))}};
}

template class StaticDropProbe<2>;
template class StaticDropProbe<3>;

}  // namespace coronet
