// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_check.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>

#include <fmt/ranges.h>

#include "coronet/cases/closed_surface.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/sphere_array.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/cases/wall_force_probe.hpp"
#include "coronet/cases/wall_motion.hpp"
#include "coronet/core/error.hpp"

namespace coronet {

namespace {

// A surface narrower than this, in spacings, has no inside to fill; one wider is in another unit.
constexpr double narrowest = 1, widest = 1e5;
constexpr double most_points = 2e9;

using Corner = Vector<double, 2>;

double cross(Corner const& a, Corner const& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Whether two edges have a point in common, ends included.
bool meet(Corner const& a, Corner const& b, Corner const& c, Corner const& d) {
    auto const between = [](Corner const& p, Corner const& q, Corner const& x) {  // of a line
        return std::min(p[0], q[0]) <= x[0] && x[0] <= std::max(p[0], q[0]) && std::min(p[1], q[1]) <= x[1] &&
               x[1] <= std::max(p[1], q[1]);
    };
    double const of_c = cross(b - a, c - a), of_d = cross(b - a, d - a), of_a = cross(d - c, a - c),
                 of_b = cross(d - c, b - c);
    if (of_c * of_d < 0 && of_a * of_b < 0) return true;
    return (of_c == 0 && between(a, b, c)) || (of_d == 0 && between(a, b, d)) || (of_a == 0 && between(c, d, a)) ||
           (of_b == 0 && between(c, d, b));
}

void check_polygon(std::vector<double> const& numbers, std::size_t wall, Errors& errors) {
    std::size_t const count = numbers.size() / 2;
    if (count < 3) return say(errors, "walls.{}.corners has {} corners: a polygon needs three or more", wall, count);
    std::vector<Corner> p;
    for (std::size_t k = 0; k < count; ++k) p.push_back({{numbers[2 * k], numbers[2 * k + 1]}});
    for (std::size_t a = 0; a < count; ++a)
        if (norm2(p[(a + 1) % count] - p[a]) == 0)
            return say(errors, "walls.{}.corners has ({}, {}) m twice in a row: leave one away", wall, p[a][0],
                       p[a][1]);
    for (std::size_t a = 0; a < count; ++a) {
        Corner const &from = p[a], &to = p[(a + 1) % count];
        for (std::size_t b = a + 1; b < count; ++b) {
            bool const next = b == a + 1, before = (b + 1) % count == a;
            Corner const &c = p[b], &d = p[(b + 1) % count];
            // Neighbours share a corner, and must not go back on each other.
            bool const back = next ? cross(to - from, d - to) == 0 && dot(to - from, d - to) < 0
                                   : before && cross(to - from, from - c) == 0 && dot(to - from, from - c) < 0;
            if (back || (!next && !before && meet(from, to, c, d)))
                return say(errors,
                           "walls.{}.corners: the edge from ({}, {}) to ({}, {}) m meets the one from ({}, {}) to ({}, "
                           "{}) m: a polygon must not cross or touch itself",
                           wall, from[0], from[1], to[0], to[1], c[0], c[1], d[0], d[1]);
        }
    }
}

void check_extent(Wall const& wall, std::size_t k, double spacing, Errors& errors) {
    auto const size = wall.surface->high() - wall.surface->low();
    double const least = std::min({size[0], size[1], size[2]}), most = std::max({size[0], size[1], size[2]});
    if (least < narrowest * spacing || most > widest * spacing)
        say(errors,
            "walls.{}.file = '{}' holds a surface of {:.4g} x {:.4g} x {:.4g} m, with walls.{}.unit = {} m, but "
            "particles "
            "are {} m apart: is that its unit? (0.001 for millimetres)",
            k, wall.file, size[0], size[1], size[2], k, wall.unit, spacing);
}

/// All lattice points around a wall, as far as the box is not periodic, are looked at, which of a wall without end
/// would take for ever.
template <int D>
void check_size(Wall const& wall, std::size_t k, Case const& c, Errors& errors) {
    auto const half = half_extents<D>(wall);
    auto const box = periodic_box<D>(c);
    double points = 1;
    for (int a = 0; a < D; ++a)
        points *= std::min(2 * (half[a] / c.particles.spacing + c.method.support),
                           box.periodic[a] ? box.size[a] / c.particles.spacing : INFINITY);
    if (points > most_points)
        say(errors,
            "walls.{} spans {:.2g} points of the lattice, more than {:.0e}: make it no larger than liquid can reach, "
            "or particles.spacing larger",
            k, points, most_points);
}

/// Of a wall that moves, its farthest corner beside sound.
template <int D>
void check_speed(Wall const& wall, std::size_t k, Case const& c, Errors& errors) {
    if (!moves(wall) || !(c.fluid.sound_speed > 0)) return;
    WallMotion<D> motion(wall, c);
    double const arm = std::sqrt(norm2(half_extents<D>(wall)));
    double fastest = 0;
    for (int n = 0; n < 1000; ++n) {
        auto const pose = motion.at(c.time.end * (n + 0.381966) / 1000);
        double const speed = std::sqrt(norm2(pose.velocity)) + std::fabs(pose.spin) * arm;
        if (speed > fastest) fastest = speed;
    }
    if (fastest >= c.fluid.sound_speed)
        say(errors,
            "walls.{} moves with up to {:.4g} m/s (displacement, turn), but fluid.sound_speed = {} m/s: make that ten "
            "times as fast as the wall",
            k, fastest, c.fluid.sound_speed);
}

void check_motion(Wall const& wall, std::size_t k, Case const& c, Errors& errors) {
    auto const check = [&](std::string const& key, std::string const& text, std::string const& unit) {
        double const start = Formula(text, c.parameters)(Vector<double, 3>{}, 0);
        if (start != 0)
            say(errors,
                "walls.{}.{} = '{}' is {} {} at t = 0, but must be 0 there: the wall begins where its centre says", k,
                key, text, start, unit);
        Formula formula(text, c.parameters);
        for (int n = 1; n <= 100; ++n) {
            double const t = c.time.end * n / 100, here = formula(Vector<double, 3>{}, t);
            if (!std::isfinite(here))
                return say(errors, "walls.{}.{} = '{}' is not finite at t = {} s", k, key, text, t);
            if (formula(Vector<double, 3>{{0.37, 0.53, 0.71}}, t) != here)
                return say(errors, "walls.{}.{} = '{}' depends on x, y or z, but a wall moves as a whole: use t alone",
                           k, key, text);
        }
    };
    for (std::string const& text : wall.displacement) check("displacement", text, "m");
    check("turn", wall.turn, "degrees");
    if (moves(wall) && c.method.scheme != "weakly-compressible")
        say(errors, "walls.{} moves, which is for method.scheme = 'weakly-compressible' only", k);
}

}  // namespace

void read_surfaces(Case& c, std::string const& file) {
    for (std::size_t k = 0; k < c.walls.size(); ++k) {
        Wall& wall = c.walls[k];
        if (wall.kind != "mesh") continue;
        auto const path = std::filesystem::path(file).parent_path() / wall.file;
        try {
            wall.surface = std::make_shared<ClosedSurface>(read_triangles(path), wall.unit, path.string());
        } catch (CaseError const& error) {
            throw CaseError(fmt::format("{}: walls.{}.file = '{}': {}", file, k, wall.file, error.what()));
        }
    }
}

void check_walls(Case const& c, Errors& errors) {
    std::set<std::string> names;
    for (std::size_t k = 0; k < c.walls.size(); ++k) {
        Wall const& wall = c.walls[k];
        auto const plain = [](unsigned char letter) { return std::isalnum(letter) || letter == '_'; };
        if (!std::all_of(wall.name.begin(), wall.name.end(), plain))
            say(errors, "walls.{}.name = '{}' cannot begin a column's name: use letters, digits and _", k, wall.name);
        if (!wall.name.empty() && !names.insert(wall.name).second)
            say(errors, "walls.{}.name = '{}' is that of another wall, too: a probe could not tell them apart", k,
                wall.name);
        if (wall.kind == "polygon") check_polygon(wall.corners, k, errors);
        if (wall.kind == "mesh") check_extent(wall, k, c.particles.spacing, errors);
        if (c.dimension == 2) check_size<2>(wall, k, c, errors);
        else check_size<3>(wall, k, c, errors);
        std::size_t const before = errors.size();
        check_motion(wall, k, c, errors);
        if (errors.size() > before) continue;
        if (c.dimension == 2) check_speed<2>(wall, k, c, errors);
        else check_speed<3>(wall, k, c, errors);
    }
}

template <int D>
void check_sliding(Case const& c, Errors& errors) {
    auto const slides = [](Wall const& wall) {
        return std::ranges::any_of(wall.surface_velocity, [](std::string const& text) { return text != "0"; });
    };
    if (std::ranges::none_of(c.walls, slides)) return;
    auto const seeds = fill_walls<D>(c);
    for (std::size_t k = 0; k < c.walls.size(); ++k) {
        if (!slides(c.walls[k])) continue;
        std::vector<Formula> velocity;
        for (std::string const& text : c.walls[k].surface_velocity) velocity.emplace_back(text, c.parameters);
        double fastest = 0;
        for (std::size_t w = 0; w < seeds.size(); ++w) {
            if (seeds.wall[w] != k) continue;
            double speed2 = 0;
            for (auto& component : velocity) {
                double const v = component(seeds.position[w] + 0.5 * seeds.to_mirror[w], 0);
                speed2 += v * v;
            }
            fastest = std::isfinite(speed2) ? std::max(fastest, std::sqrt(speed2)) : INFINITY;
        }
        if (!std::isfinite(fastest))
            say(errors, "walls.{}.surface_velocity = [{}] is not finite all over the wall at t = 0", k,
                fmt::join(c.walls[k].surface_velocity, ", "));
        else if (c.fluid.sound_speed > 0 && fastest >= c.fluid.sound_speed)
            say(errors,
                "walls.{}.surface_velocity is up to {:.4g} m/s, but fluid.sound_speed = {} m/s: make that ten times as "
                "fast",
                k, fastest, c.fluid.sound_speed);
    }
}
template void check_sliding<2>(Case const&, Errors&);
template void check_sliding<3>(Case const&, Errors&);

void check_wall_probe(Case const& c, std::size_t k, Errors& errors) {
    ProbeKeys const& probe = c.probes[k];
    auto const value = [&](std::string const& text) { return Formula(text, c.parameters)(Vector<double, 3>{}, 0); };
    bool const drag = probe.kind == "drag", impact = probe.kind == "impact", dam = impact || probe.kind == "dam-break";
    if ((probe.kind == "wall-force" || drag) && (probe.wall.empty() || wall_named(probe.wall, c) == c.walls.size())) {
        std::vector<std::string> names;
        for (Wall const& wall : c.walls)
            if (!wall.name.empty()) names.push_back("'" + wall.name + "'");
        say(errors, "probes.{}.wall = '{}' is no wall's name; {}", k, probe.wall,
            names.empty() ? "no wall has one: give it one with walls.0.name"
                          : fmt::format("there is {}", fmt::join(names, ", ")));
    }
    if ((impact || probe.kind == "sensor") && c.walls.empty())
        say(errors, "probes.{}: a pressure sensor is in a wall: there is none", k);
    if (dam && !(c.fluid.gravity[1] < 0 && c.fluid.gravity[0] == 0))
        say(errors, "probes.{}: a dam breaks under fluid.gravity along -y", k);
    if (dam)
        for (auto const* text : {&probe.depth, &probe.width})
            if (!(value(*text) > 0 && std::isfinite(value(*text))))
                say(errors, "probes.{}.{} = {} must be finite and above 0 m", k,
                    text == &probe.depth ? "depth" : "width", *text);
    if (!drag) return;
    if (c.domain.periodic != "xyz" || c.domain.size[0] != c.domain.size[1] || c.domain.size[0] != c.domain.size[2])
        return say(errors, "probes.{}: an array of spheres is a cube with domain.periodic = 'xyz'", k);
    double const radius = value(probe.radius);
    if (!(radius > 0 && radius <= c.domain.size[0] / 2))
        say(errors, "probes.{}.radius = {} must be above 0 m and at most half of domain.size", k, probe.radius);
    double const fraction = 4 * std::numbers::pi / 3 * std::pow(radius / c.domain.size[0], 3);
    if (!std::isfinite(sphere_array_drag(fraction)))
        say(errors,
            "probes.{}.radius = {} makes a volume fraction of {:.4g}: theory is known up to 0.216, and at 0.343, 0.45 "
            "and "
            "0.5236",
            k, probe.radius, fraction);
    if (!(c.fluid.rheology == "newtonian" && c.fluid.viscosity > 0))
        say(errors, "probes.{}: the drag on spheres is known for a Newtonian liquid of a viscosity above 0 Pa s", k);
    if (!(value(c.fluid.body_force[0]) + c.fluid.gravity[0] > 0))
        say(errors, "probes.{}: a body force along +x must drive the liquid past the spheres", k);
}

}  // namespace coronet
