// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/cases/totals.hpp"

namespace coronet {

std::vector<std::string> DropProbe::columns() const {
    return {"circularity", "radius_mean", "area", "surface_particles", "voids", "spacing_p01"};
}

std::vector<double> DropProbe::sample(Snapshot<2> const& now) {
    auto const total = totals(now.particles);
    if (!start_) {
        double const area = total.mass / case_.fluid.density;
        start_ = {total.mass, area, std::sqrt(area / std::numbers::pi), total.centre(), total.momentum};
    }
    auto const line = start_->centre + now.time / start_->mass * start_->momentum;
    centre_drift_ = std::max(centre_drift_, std::sqrt(norm2(total.centre() - line)) / start_->radius);
    momentum_drift_ = std::max(momentum_drift_, std::sqrt(norm2(total.momentum - start_->momentum)));

    auto const& drop = now.outline();
    circularity_ = drop.farthest / drop.nearest;
    area_error_ = drop.area / start_->area - 1;
    area_error_max_ = std::max(area_error_max_, std::fabs(area_error_));
    return {circularity_,
            drop.mean_radius,
            drop.area,
            static_cast<double>(drop.surface_particles),
            static_cast<double>(drop.voids),
            drop.spacing_p01};
}

std::vector<Measure> DropProbe::measures() const {
    if (!start_) return {};
    std::string const area = "area within the outline moved out by half a spacing, over mass/density";
    std::vector<Measure> measures{
        {"circularity_final", circularity_, 1.0, circularity_ - 1,
         "a circle: largest over smallest radius of the outline"},
        {"area_error", area_error_, 0.0, area_error_, area + ", at the end"},
        {"area_error_max", area_error_max_, 0.0, area_error_max_, area + ", largest of all samples"}};
    bool const is_free = no_outer_force(case_);
    auto const add_drift = [&](std::string const& name, double drift, std::string const& over) {
        if (is_free)
            measures.push_back({name, drift, 0.0, drift, "conservation; largest of all samples, over " + over});
        else measures.push_back({name, drift, {}, {}, "by the outer force, too; largest of all samples, over " + over});
    };
    add_drift("centre_drift", centre_drift_, "the radius, from the straight line of the initial momentum");
    double const speed = std::sqrt(case_.fluid.surface_tension / (case_.fluid.density * start_->radius));
    if (speed > 0)
        add_drift("momentum_drift", momentum_drift_ / (start_->mass * speed), "mass times sqrt(sigma/(rho R))");
    return measures;
}

}  // namespace coronet
