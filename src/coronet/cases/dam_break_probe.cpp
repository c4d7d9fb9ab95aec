// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/dam_break_probe.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/shapes.hpp"

namespace coronet {

namespace {

constexpr double until = 2.5;  // t sqrt(2 g/H)
constexpr double low = 0.1;    // what is higher above the floor, over H, is no part of the front

struct Reference {
    char const *table, *name, *source;
    double height_over_width;
};
constexpr Reference references[] = {
    {"dambreak_martin_moyce1952_a1125", "martin_moyce_1125", "Martin and Moyce (1952), a = 1.125 in", 2},
    {"dambreak_martin_moyce1952_a225", "martin_moyce_225", "Martin and Moyce (1952), a = 2.25 in", 2},
    {"dambreak_koshizuka_oka1996_front", "koshizuka", "Koshizuka and Oka (1996)", 2},
    {"dambreak_martin_moyce1952_square", "martin_moyce_square", "Martin and Moyce (1952), a = 2.25 in", 1},
    {"dambreak_lobovsky2014_front_H600", "lobovsky_600", "Lobovsky et al. (2014), H = 0.6 m", 1},
    {"dambreak_lobovsky2014_front_H300", "lobovsky_300", "Lobovsky et al. (2014), H = 0.3 m", 0.5}};

std::vector<Reference> references_of(double height_over_width) {
    std::vector<Reference> found;
    for (Reference const& reference : references)
        if (std::fabs(height_over_width / reference.height_over_width - 1) < 0.005) found.push_back(reference);
    return found;
}

}  // namespace

Vector<double, 2> lower_corner(Case const& c) {
    Vector<double, 2> corner{{INFINITY, INFINITY}};
    for (Shape const& shape : c.shapes)
        for (std::size_t k = 0; k < 2; ++k)
            corner[k] = std::min(corner[k], shape.centre[k] - half_extents<2>(shape)[k]);
    return corner;
}

DamBreakProbe::DamBreakProbe(ProbeKeys const& keys, Case const& c)
    : solid_(Solid<2>::at_rest(c)),
      gravity_(-c.fluid.gravity[1]),
      height_(Formula(keys.depth, c.parameters)(Vector<double, 2>{}, 0)),
      width_(Formula(keys.width, c.parameters)(Vector<double, 2>{}, 0)),
      corner_(lower_corner(c)),
      half_spacing_(c.particles.spacing / 2) {}

std::vector<double> DamBreakProbe::sample(Snapshot<2> const& now) {
    auto const view = now.particles.view();
    auto const in_solid = [&](std::size_t i) { return solid_.holds(view.get<Position>(i)); };
    double const farthest = max_over(now.particles.owned(), 0.0, [&](std::size_t i) {
        auto const x = view.get<Position>(i) - corner_;
        return x[1] > low * height_ || in_solid(i) ? 0 : x[0];
    });
    double const front = farthest + half_spacing_;
    front_.time.push_back(now.time * std::sqrt(2 * gravity_ / width_));
    front_.value.push_back(front / width_);
    through_ = sum_over(now.particles.owned(), 0.0, [&](std::size_t i) { return in_solid(i) ? 1.0 : 0.0; });
    return {front, through_};
}

std::vector<Profile> DamBreakProbe::profiles() const {
    std::vector<Profile> all;
    for (Reference const& reference : references_of(height_ / width_))
        all.push_back(beside(front_, builtin_curve(reference.table), reference.table));
    return all;
}

std::vector<Measure> DamBreakProbe::measures() const {
    std::vector<Measure> list;
    double const last = until * std::sqrt(height_ / width_);  // t sqrt(2 g/W)
    double worst = 0;
    for (Reference const& reference : references_of(height_ / width_)) {
        Curve const measured = builtin_curve(reference.table);
        std::string const name = reference.name, source = reference.source;
        double const largest = largest_difference(front_, measured, last),
                     late = fitted_lateness(front_, measured, last),
                     after = largest_difference(front_, measured, last, late);
        list.push_back(
            {"front_error_" + name, largest, 0.0, largest, source + "; the largest of relative differences"});
        list.push_back({"front_late_" + name,
                        late,
                        {},
                        {},
                        source + "; by how much its t sqrt(2 g/W) would have to be late to fit best"});
        list.push_back({"front_error_late_" + name, after, 0.0, after,
                        source + "; the largest of relative differences if it is late by that"});
        if (!std::isnan(worst) && !(std::fabs(largest) <= worst)) worst = std::fabs(largest);  // not known once, never
    }
    if (!list.empty())
        list.push_back({"front_error", worst, 0.0, worst, "the largest of those, none taken to be late"});
    list.push_back({"through_walls", through_, 0.0, through_, "no particle passes a wall"});
    return list;
}

}  // namespace coronet
