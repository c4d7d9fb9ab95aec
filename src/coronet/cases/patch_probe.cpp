// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/patch_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/fragments.hpp"
#include "coronet/cases/point_value.hpp"

namespace coronet {

namespace {

/// Twice the signed area inside a closed line (the shoelace sum).
double shoelace(std::vector<Vector<double, 2>> const& line) {
    double twice = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
        auto const &a = line[k], &b = line[(k + 1) % line.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice;
}

}  // namespace

PatchProbe::PatchProbe(ProbeKeys const& keys, Case const& c)
    : case_(c),
      kernel_(probe_kernel<2>(c)),
      spacing_(c.particles.spacing),
      side_(Formula(keys.side, c.parameters)(Vector<double, 2>{}, 0)),
      omega_(Formula(keys.angular_velocity, c.parameters)(Vector<double, 2>{}, 0)) {}

std::vector<std::string> PatchProbe::columns() const {
    return {"corner_radius", "side_half_width", "centre_pressure", "fragments", "area", "exact_corner_radius"};
}

void PatchProbe::remember_surface(Particles<2> const& particles) {
    auto const view = particles.view();
    struct Point {
        double angle, radius;
        std::int64_t id;
        double volume;
    };
    std::vector<Point> line;
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        if (view.get<Surface>(i) == 0) continue;
        auto const x = view.get<Position>(i);
        line.push_back({std::atan2(x[1], x[0]), std::sqrt(norm2(x)), particles.id[i], view.get<Volume>(i)});
    }
    std::sort(line.begin(), line.end(), [](Point const& a, Point const& b) { return a.angle < b.angle; });
    for (Point const& p : line) outline_.push_back(p.id);

    // In each quadrant the farthest surface particle is a corner, in each quarter around an axis the nearest a
    // mid-side.
    for (int quarter = 0; quarter < 4; ++quarter) {
        auto const of_quarter = [&](double shift, bool farthest) {
            Point const* best = nullptr;
            for (Point const& p : line) {
                double const from =
                    std::remainder(p.angle - (quarter + shift) * std::numbers::pi / 2, 2 * std::numbers::pi);
                if (std::fabs(from) > std::numbers::pi / 4) continue;
                if (!best || (farthest ? p.radius > best->radius : p.radius < best->radius)) best = &p;
            }
            return best ? best->id : line.front().id;
        };
        corners_.push_back(of_quarter(0.5, true));
        mid_sides_.push_back(of_quarter(0, false));
    }
    outside_area_ = 0;
    for (Point const& p : line)
        outside_area_ += p.volume * (std::find(corners_.begin(), corners_.end(), p.id) != corners_.end() ? 0.75 : 0.5);
}

PatchProbe::Seen PatchProbe::material_outline(Particles<2> const& particles) const {
    auto const view = particles.view();
    std::vector<std::size_t> place(particles.owned());
    for (std::size_t i = 0; i < particles.owned(); ++i) place[static_cast<std::size_t>(particles.id[i])] = i;
    auto const position = [&](std::int64_t id) { return view.get<Position>(place[static_cast<std::size_t>(id)]); };
    auto const mean_radius = [&](std::vector<std::int64_t> const& ids) {
        double sum = 0;
        for (auto const id : ids) sum += std::sqrt(norm2(position(id)));
        return sum / static_cast<double>(ids.size());
    };
    std::vector<Vector<double, 2>> line;
    for (auto const id : outline_) line.push_back(position(id));
    return {mean_radius(corners_), mean_radius(mid_sides_), std::fabs(shoelace(line)) / 2 + outside_area_};
}

PatchProbe::Seen PatchProbe::outline_as_it_lies(Snapshot<2> const& now) const {
    using std::numbers::pi;
    auto const& outline = now.outline();
    double farthest[4] = {}, nearest[4];
    std::fill_n(nearest, 4, outline.farthest);
    for (auto const& x : outline.line) {
        double const r = std::sqrt(norm2(x)), angle = std::atan2(x[1], x[0]) + std::atan(omega_ * now.time);
        auto const quarter = [&](double from) {
            double const turns = (angle - from) / (2 * pi);
            return static_cast<std::size_t>(4 * (turns - std::floor(turns))) % 4;
        };
        double &far = farthest[quarter(0)], &near = nearest[quarter(pi / 4)];
        far = std::max(far, r);
        near = std::min(near, r);
    }
    auto const mean = [](double const(&four)[4]) { return (four[0] + four[1] + four[2] + four[3]) / 4; };
    return {mean(farthest), mean(nearest), outline.area};
}

std::vector<double> PatchProbe::sample(Snapshot<2> const& now) {
    auto const& particles = now.particles;
    bool const first = first_area_ == 0;
    if (first) remember_surface(particles);
    auto const seen = case_.method.shifting == "none" ? material_outline(particles) : outline_as_it_lies(now);
    area_ = seen.area;
    if (first) first_area_ = area_;
    fragments_ = fragments(particles, 3 * spacing_);
    double const p = value_at(particles, kernel_, {}, [&](std::size_t i) { return particles.view().get<Pressure>(i); });
    return {seen.corner, seen.side,
            p,           static_cast<double>(fragments_),
            area_,       side_ / std::numbers::sqrt2 * std::sqrt(1 + std::pow(omega_ * now.time, 2))};
}

std::vector<Measure> PatchProbe::measures() const {
    double const error = area_ / first_area_ - 1;
    return {{"fragments_final", static_cast<double>(fragments_), 1.0, fragments_ - 1.0,
             "the exact patch stays in one piece"},
            {"area_error", error, 0.0, error, "area inside the outline, relative to its first value"}};
}

}  // namespace coronet
