// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/impact_probe.hpp"

#include <cmath>

#include "coronet/cases/dam_break_probe.hpp"
#include "coronet/cases/formula.hpp"

namespace coronet {

namespace {

constexpr double arrived = 0.1;                         // pressure over rho g H
constexpr double plateau_from = 3.3, plateau_to = 5.3;  // t sqrt(g/H)
constexpr double tank = 5.366, column = 2;              // length of the tank and width of the column, over H

double number(std::string const& formula, Case const& c) {
    return Formula(formula, c.parameters)(Vector<double, 2>{}, 0);
}

}  // namespace

std::vector<ImpactProbe::Reference> ImpactProbe::references_of(ProbeKeys const& keys, Case const& c, double height,
                                                               double width) {
    static constexpr Reference known[] = {
        {"dambreak_lobovsky2014_P1", "pressure_error", "Lobovsky et al. (2014), measured", 0.01, 0.014},
        {"dambreak_decourcy2024_P1", "pressure_error_inviscid", "De Courcy et al. (2024), computed", 0.01, 0.014},
        {"dambreak_lobovsky2014_P3", "pressure_error_p3", "Lobovsky et al. (2014), measured", 0.1, 0.014},
        {"dambreak_decourcy2024_P3", "pressure_error_p3_inviscid", "De Courcy et al. (2024), computed", 0.1, 0.014},
        {"dambreak_lobovsky2014_P4", "pressure_error_p4", "Lobovsky et al. (2014), measured", 0.267, 0.014},
        {"dambreak_decourcy2024_P4", "pressure_error_p4_inviscid", "De Courcy et al. (2024), computed", 0.267, 0.014},
        {"dambreak_buchner2002_pressure", "pressure_error_buchner", "Buchner (2002), measured", 0.267, 0.15}};
    auto const near = [&](double length, double over_height) {
        return std::fabs(length / height - over_height) < 0.005;
    };
    auto const corner = lower_corner(c);
    std::vector<Reference> found;
    for (Reference const& reference : known)
        if (near(width, column) && near(keys.at[0] - corner[0], tank) &&
            near(keys.at[1] - corner[1], reference.above) && near(keys.sensor_width, reference.wide))
            found.push_back(reference);
    return found;
}

ImpactProbe::ImpactProbe(ProbeKeys const& keys, Case const& c)
    : name_(keys.name), sensor_({{keys.at[0], keys.at[1]}}, keys.sensor_width, c) {
    double const g = -c.fluid.gravity[1], height = number(keys.depth, c);
    unit_ = c.fluid.density * g * height;
    rate_ = std::sqrt(g / height);
    references_ = references_of(keys, c, height, number(keys.width, c));
}

std::vector<double> ImpactProbe::sample(Snapshot<2> const& now) {
    double const pressure = sensor_.pressure(now.particles);
    pressure_.time.push_back(now.time * rate_);
    pressure_.value.push_back(pressure / unit_);
    return {pressure};
}

std::vector<Profile> ImpactProbe::profiles() const {
    std::vector<Profile> all;
    for (Reference const& reference : references_)
        all.push_back(beside(pressure_, builtin_curve(reference.table), reference.table));
    return all;
}

std::vector<Measure> ImpactProbe::measures() const {
    std::vector<Measure> list;
    double const mean = pressure_.mean(plateau_from, plateau_to);
    for (Reference const& reference : references_) {
        Curve const elsewhere = builtin_curve(reference.table);
        std::string const source = reference.source, measure = reference.measure;
        double const error = mean / elsewhere.mean(plateau_from, plateau_to) - 1;
        list.push_back({measure, error, 0.0, error,
                        source + "; of the mean from t sqrt(g/H) = 3.3 to 5.3, if the run goes there"});
        if (measure != "pressure_error") continue;
        double const late = pressure_.first_above(arrived) / elsewhere.first_above(arrived) - 1;
        list.push_back(
            {"arrival_error", late, 0.0, late, source + "; of the time at which the sensor feels 0.1 rho g H"});
    }
    return list;
}

}  // namespace coronet
