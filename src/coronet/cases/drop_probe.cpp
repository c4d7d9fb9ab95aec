// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/cases/totals.hpp"

namespace coronet {

namespace {

double content_of(DropOutline const& drop) { return drop.area; }
double content_of(DropSurface const& drop) { return drop.volume; }

template <int D>
std::string const content_name = D == 2 ? "area" : "volume";

}  // namespace

template <int D>
std::vector<std::string> DropProbe<D>::columns() const {
    std::vector<std::string> names{"circularity",       "radius_mean", D == 2 ? "area" : "drop_volume",
                                   "surface_particles", "voids",       "spacing_p01"};
    ledger_.add_columns(names);
    return names;
}

template <int D>
std::vector<double> DropProbe<D>::sample(Snapshot<D> const& now) {
    auto const total = totals(now.particles);
    if (!start_) {
        double const content = total.mass / case_.fluid.density,
                     unit = D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
        start_ = {total.mass, content, std::pow(content / unit, 1.0 / D), total.centre(), total.momentum};
    }
    auto const line = start_->centre + now.time / start_->mass * start_->momentum;
    centre_drift_ = std::max(centre_drift_, std::sqrt(norm2(total.centre() - line)) / start_->radius);
    momentum_drift_ = std::max(momentum_drift_, std::sqrt(norm2(total.momentum - start_->momentum)));

    auto const& drop = now.outline();
    circularity_ = drop.farthest / drop.nearest;
    content_error_ = content_of(drop) / start_->content - 1;
    content_error_max_ = std::max(content_error_max_, std::fabs(content_error_));
    std::vector<double> row{circularity_,
                            drop.mean_radius,
                            content_of(drop),
                            static_cast<double>(drop.surface_particles),
                            static_cast<double>(drop.voids),
                            drop.spacing_p01};
    ledger_.sample(now, row);
    return row;
}

template <int D>
std::vector<Measure> DropProbe<D>::measures() const {
    if (!start_) return {};
    std::string const name = content_name<D>, source = name + " within the boundary, over mass/density";
    std::vector<Measure> measures{
        {"circularity_final", circularity_, 1.0, circularity_ - 1,
         std::string(D == 2 ? "a circle" : "a sphere") + ": largest over smallest radius of the outline"},
        {name + "_error", content_error_, 0.0, content_error_, source + ", at the end"},
        {name + "_error_max", content_error_max_, 0.0, content_error_max_, source + ", largest of all samples"}};
    bool const is_free = no_outer_force(case_);
    auto const add_drift = [&](std::string const& what, double drift, std::string const& over) {
        if (is_free)
            measures.push_back({what, drift, 0.0, drift, "conservation; largest of all samples, over " + over});
        else measures.push_back({what, drift, {}, {}, "by the outer force, too; largest of all samples, over " + over});
    };
    add_drift("centre_drift", centre_drift_, "the radius, from the straight line of the initial momentum");
    double const speed = std::sqrt(case_.fluid.surface_tension / (case_.fluid.density * start_->radius));
    if (speed > 0)
        add_drift("momentum_drift", momentum_drift_ / (start_->mass * speed), "mass times sqrt(sigma/(rho R))");
    ledger_.add_measures(measures);
    return measures;
}

template class DropProbe<2>;
template class DropProbe<3>;

}  // namespace coronet
