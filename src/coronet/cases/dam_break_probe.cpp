// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/dam_break_probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "coronet/cases/builtin.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/shapes.hpp"

namespace coronet {

namespace {

constexpr double arrived = 0.1;                                            // pressure over rho g H
constexpr double front_until = 2.5, plateau_from = 3.3, plateau_to = 5.3;  // t sqrt(2 g/H); t sqrt(g/H)

struct Reference {
    char const *table, *measure, *source;
};
constexpr Reference fronts[] = {
    {"dambreak_martin_moyce1952_a1125", "front_error_martin_moyce_1125", "Martin and Moyce (1952), a = 1.125 in"},
    {"dambreak_martin_moyce1952_a225", "front_error_martin_moyce_225", "Martin and Moyce (1952), a = 2.25 in"},
    {"dambreak_koshizuka_oka1996_front", "front_error_koshizuka", "Koshizuka and Oka (1996)"}};
constexpr Reference pressures[] = {{"dambreak_lobovsky2014_P1", "pressure_error", "Lobovsky et al. (2014), measured"},
                                   {"dambreak_decourcy2024_P1", "pressure_error_inviscid",
                                    "De Courcy et al. (2024), computed without viscosity in 2D"}};

Vector<double, 2> point(std::vector<double> const& x) { return {{x[0], x[1]}}; }

}  // namespace

double Curve::at(double t) const {
    auto const after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    if (after == 0) return value.front();
    if (after == time.size()) return value.back();
    double const share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return value[after - 1] + share * (value[after] - value[after - 1]);
}

double Curve::mean(double from, double to) const {
    if (time.empty() || time.front() > from || time.back() < to) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0, t = from, v = at(from);
    auto const go = [&](double next, double value_there) {
        sum += (next - t) * (v + value_there) / 2;
        t = next;
        v = value_there;
    };
    for (std::size_t k = 0; k < time.size(); ++k)
        if (time[k] > from && time[k] < to) go(time[k], value[k]);
    go(to, at(to));
    return sum / (to - from);
}

double Curve::first_above(double least) const {
    for (std::size_t k = 0; k < time.size(); ++k)
        if (value[k] > least) return time[k];
    return std::numeric_limits<double>::quiet_NaN();
}

Curve builtin_curve(std::string const& name) {
    Curve curve;
    for (BuiltinFile const& table : builtin_tables()) {
        if (table.name != name) continue;
        std::istringstream lines{std::string(table.text)};
        for (std::string line; std::getline(lines, line);) {
            double t = 0, v = 0;
            char comma = 0;
            if (!(std::istringstream(line) >> t >> comma >> v)) continue;  // comments and the names of the columns
            curve.time.push_back(t);
            curve.value.push_back(v);
        }
    }
    return curve;
}

DamBreakProbe::DamBreakProbe(ProbeKeys const& keys, Case const& c)
    : sensor_(point(keys.at), keys.sensor_width, c),
      solid_(c),
      density_(c.fluid.density),
      gravity_(-c.fluid.gravity[1]),
      height_(Formula(keys.depth, c.parameters)(Vector<double, 2>{}, 0)),
      width_(Formula(keys.width, c.parameters)(Vector<double, 2>{}, 0)),
      half_spacing_(c.particles.spacing / 2) {
    left_ = INFINITY;
    for (Shape const& shape : c.shapes) left_ = std::min(left_, shape.centre[0] - half_extents<2>(shape)[0]);
}

std::vector<double> DamBreakProbe::sample(Snapshot<2> const& now) {
    auto const x = now.particles.template get<Position>(0);
    double const farthest = max_over(now.particles.owned(), left_, [&](std::size_t i) {
        return solid_.holds(now.particles.view().get<Position>(i)) ? left_ : x[i];
    });
    double const front = farthest + half_spacing_ - left_, pressure = sensor_.pressure(now.particles);
    front_.time.push_back(now.time * std::sqrt(2 * gravity_ / width_));
    front_.value.push_back(front / width_);
    pressure_.time.push_back(now.time * std::sqrt(gravity_ / height_));
    pressure_.value.push_back(pressure / (density_ * gravity_ * height_));
    auto const view = now.particles.view();
    through_ = sum_over(now.particles.owned(), 0.0,
                        [&](std::size_t i) { return solid_.holds(view.get<Position>(i)) ? 1.0 : 0.0; });
    return {front, pressure, through_};
}

std::vector<Profile> DamBreakProbe::profiles() const {
    std::vector<Profile> all;
    auto const add = [&](Reference const& reference, Curve const& computed) {
        Curve const measured = builtin_curve(reference.table);
        Profile profile{reference.table, {}, {}, {}};
        for (std::size_t k = 0; k < measured.time.size(); ++k) {
            bool const seen = !computed.time.empty() && measured.time[k] <= computed.time.back();
            if (!seen) continue;
            profile.position.push_back(measured.time[k]);
            profile.computed.push_back(computed.at(measured.time[k]));
            profile.reference.push_back(measured.value[k]);
        }
        all.push_back(profile);
    };
    if (std::fabs(height_ / width_ - 2) < 0.01)
        for (Reference const& reference : fronts) add(reference, front_);
    if (std::fabs(width_ / height_ - 2) < 0.01)
        for (Reference const& reference : pressures) add(reference, pressure_);
    return all;
}

std::vector<Measure> DamBreakProbe::measures() const {
    std::vector<Measure> list;
    double const until = front_until * std::sqrt(height_ / width_);  // t sqrt(2 g/W)
    if (std::fabs(height_ / width_ - 2) < 0.01) {
        double worst = 0;
        for (Reference const& reference : fronts) {
            Curve const measured = builtin_curve(reference.table);
            double largest = 0;
            for (std::size_t k = 0; k < measured.time.size() && measured.time[k] <= until; ++k) {
                double const error = measured.time[k] <= front_.time.back()
                                         ? front_.at(measured.time[k]) / measured.value[k] - 1
                                         : std::numeric_limits<double>::quiet_NaN();
                if (!(std::fabs(error) <= std::fabs(largest))) largest = error;
            }
            list.push_back({reference.measure, largest, 0.0, largest,
                            std::string(reference.source) + "; the largest of relative differences"});
            if (!(std::fabs(largest) <= worst)) worst = std::fabs(largest);
        }
        list.push_back({"front_error", worst, 0.0, worst, "the largest of them"});
    }
    if (std::fabs(width_ / height_ - 2) < 0.01) {
        double const mean = pressure_.mean(plateau_from, plateau_to), arrival = pressure_.first_above(arrived),
                     measured = builtin_curve(pressures[0].table).first_above(arrived);
        list.push_back({"arrival_error", arrival / measured - 1, 0.0, arrival / measured - 1,
                        std::string(pressures[0].source) + "; of the time at which the sensor feels 0.1 rho g H"});
        for (Reference const& reference : pressures) {
            double const error = mean / builtin_curve(reference.table).mean(plateau_from, plateau_to) - 1;
            list.push_back({reference.measure, error, 0.0, error,
                            std::string(reference.source) + "; of the mean from t sqrt(g/H) = 3.3 to 5.3"});
        }
    }
    list.push_back({"through_walls", through_, 0.0, through_, "no particle passes a wall"});
    return list;
}

}  // namespace coronet
