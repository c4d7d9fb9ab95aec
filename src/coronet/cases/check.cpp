// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/check.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/cases/fill.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/initial_frame.hpp"
#include "coronet/cases/lattice.hpp"
#include "coronet/cases/probe.hpp"
#include "coronet/cases/rheology_check.hpp"
#include "coronet/cases/series_columns.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/cases/shapes.hpp"
#include "coronet/cases/shells_check.hpp"
#include "coronet/cases/wall_check.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/core/error.hpp"
#include "coronet/surface/tension.hpp"

namespace coronet {

namespace {

constexpr double most_particles = 5e8, most_frames = 1e6, most_rows = 1e8, most_steps = 1e10;
constexpr double least_mixed_radius = 1e-7;  // [m]; W'/r in 3D is of order 1/H^5, and a float ends at 1e38

void check_names(Case const& c, Errors& errors) {
    auto const plain = [](std::string const& name, std::string const& others) {
        return !name.empty() && std::all_of(name.begin(), name.end(), [&](char letter) {
            return std::isalnum(static_cast<unsigned char>(letter)) || others.find(letter) != std::string::npos;
        });
    };
    if (!plain(c.name, "-_.") || c.name.front() == '.')
        say(errors, "name = '{}' cannot name a directory: use letters, digits, -, _ and .", c.name);
    for (std::size_t k = 0; k < c.probes.size(); ++k)
        if ((c.probes[k].kind == "value" || c.probes[k].kind == "sensor") && !plain(c.probes[k].name, "_"))
            say(errors, "probes.{}.name = '{}' cannot name a column: use letters, digits and _", k, c.probes[k].name);
}

template <int D>
void check_shapes(Case const& c, Errors& errors) {
    double const dx = c.particles.spacing;
    for (std::size_t k = 0; k < c.shapes.size(); ++k) {
        for (Cut const& cut : c.shapes[k].cuts)
            if (std::all_of(cut.normal.begin(), cut.normal.end(), [](double n) { return n == 0; }))
                say(errors, "shapes.{}.cuts has a normal of length zero: it cuts nowhere", k);
        for (double const x : c.shapes[k].centre)
            if (std::fabs(x) > 1e9 * dx)
                say(errors,
                    "shapes.{}.centre = [{}] is more than 1e9 spacings from x = 0: round-off would show; move "
                    "the case to x = 0",
                    k, fmt::join(c.shapes[k].centre, ", "));
    }
    check_walls(c, errors);
    double const expected = expected_particles<D>(c);
    for (std::size_t k = 0; k < c.shapes.size(); ++k)
        if (auto const half = half_extents<D>(c.shapes[k]); std::sqrt(norm2(half)) > 1e9 * dx)
            say(errors, "shapes.{} is wider than 1e9 spacings: make it smaller", k);
    if (!(expected < most_particles))
        say(errors,
            "particles.spacing = {} m would make about {:.1e} particles; at most {:.0e} are allowed: use a "
            "spacing above {:.2g} m",
            dx, expected, most_particles, dx * std::pow(expected / most_particles, 1.0 / D));
}

template <int D>
void check_domain(Case const& c, Errors& errors) {
    auto const box = periodic_box<D>(c);
    double const dx = c.particles.spacing, thinnest = 2 * c.method.support * dx;
    Lattice<D> const lattice(c);
    for (int k = 0; k < D; ++k) {
        if (!box.periodic[k]) continue;
        Vector<double, D> across;
        across[k] = box.size[k];
        if (box.size[k] < thinnest)
            say(errors,
                "domain.size = [{}] is thinner along {} than twice the kernel's radius, {:.4g} m: a particle would "
                "meet images of itself; make it wider",
                fmt::join(c.domain.size, ", "), "xyz"[k], thinnest);
        else if (c.particles.lattice != "shells" && !lattice.repeats_after(across))
            say(errors,
                "domain.size = [{}] does not hold whole cells of the lattice along {} at particles.spacing = {} m: "
                "there would be a seam",
                fmt::join(c.domain.size, ", "), "xyz"[k], dx);
    }
    auto const implicit_with = [&](std::string const& key, std::string const& found, std::string const& only) {
        if (c.method.scheme == "weakly-compressible" && c.method.viscous_step == "implicit" && found != only)
            say(errors, "method.viscous_step = 'implicit' goes with {} = '{}' in this scheme, not '{}'", key, only,
                found);
    };
    implicit_with("method.viscous_force", c.method.viscous_force, "morris");
    implicit_with("method.gradient", c.method.gradient, "sph");
    implicit_with("time.stepping", c.time.stepping, "predictor-corrector");
    Rheology const law = rheology_of(c);
    bool const inviscid = law.model == Rheology::Model::newtonian && law.viscosity == 0;
    if (!c.walls.empty() && c.method.scheme == "weakly-compressible" && !inviscid && c.method.viscous_force != "morris")
        say(errors,
            "a wall is not for method.viscous_force = '{}': use 'morris', which sees the motions that a stress at "
            "walls "
            "sets off",
            c.method.viscous_force);
    bool const closed = box.any() || !c.walls.empty();
    std::string const what = c.walls.empty() ? "domain.periodic" : "a wall";
    if (closed && c.method.scheme == "projection")
        say(errors, "{} is not for method.scheme = 'projection': use 'weakly-compressible'", what);
    if (closed && c.method.gradient == "cph")
        say(errors, "{} is not for method.gradient = 'cph': use 'fpm' or 'sph'", what);
    if (!c.walls.empty() && c.time.stepping == "symplectic-euler" && c.method.gradient == "fpm" &&
        c.method.viscous_force == "stress")
        say(errors,
            "a wall is not for time.stepping = 'symplectic-euler' with method.gradient = 'fpm' and "
            "method.viscous_force = 'stress': use 'morris', or 'predictor-corrector'");
    int const periods = static_cast<int>(std::count(box.periodic, box.periodic + D, true));
    bool const goes_on = D == 3 && periods == 1 && c.surface.tension_force == "boundary";
    if (closed && c.fluid.surface_tension > 0 && (!c.walls.empty() || !goes_on))
        say(errors,
            "{} is not for a liquid with fluid.surface_tension = {} N/m: set it to 0 (in 3D, with "
            "surface.tension_force = 'boundary' and without walls, the liquid may be periodic along one axis)",
            what, c.fluid.surface_tension);
}

template <int D>
void check_probes(Case const& c, Errors& errors) {
    auto const value = [&](std::string const& text) { return Formula(text, c.parameters)(Vector<double, D>{}, 0); };
    for (std::size_t k = 0; k < c.probes.size(); ++k) {
        ProbeKeys const& probe = c.probes[k];
        double sum = 0, largest = 0;
        for (std::string const& rate : probe.rates) {
            sum += value(rate);
            largest = std::max(largest, std::fabs(value(rate)));
        }
        if (probe.kind == "stretching" && largest == 0)
            say(errors, "probes.{}.rates are all 0: there is no flow to compare with", k);
        if (!(std::fabs(sum) <= 1e-9 * largest))
            say(errors,
                "probes.{}.rates = [{}] add up to {:.4g} 1/s: the exact drop keeps its volume, so the sum must "
                "be 0",
                k, fmt::join(probe.rates, ", "), sum);
        for (std::string const& axis : probe.semi_axes)
            if (!(value(axis) > 0 && std::isfinite(value(axis))))
                say(errors, "probes.{}.semi_axes = [{}] must be finite and above 0 m", k,
                    fmt::join(probe.semi_axes, ", "));
        if (probe.kind == "hydrostatic" && !(value(probe.depth) > 0 && std::isfinite(value(probe.depth))))
            say(errors, "probes.{}.depth = {} must be finite and above 0 m", k, probe.depth);
        if (probe.kind == "hydrostatic" &&
            std::all_of(c.fluid.gravity.begin(), c.fluid.gravity.end(), [](double g) { return g == 0; }))
            say(errors, "probes.{}: liquid at rest wants fluid.gravity", k);
        if (probe.kind == "cavity" && !(c.fluid.rheology == "newtonian" && c.fluid.viscosity > 0))
            say(errors, "probes.{}: a cavity needs a Newtonian liquid of a viscosity above 0 Pa s", k);
        if (probe.kind == "cavity" && !(value(probe.upper_velocity) > 0))
            say(errors, "probes.{}.upper_velocity = {} must be above 0 m/s", k, probe.upper_velocity);
        if (probe.kind == "taylor-green" && !(c.fluid.rheology == "newtonian" && value(probe.speed) > 0))
            say(errors, "probes.{}: the vortices of Taylor and Green need a Newtonian liquid and a speed above 0 m/s",
                k);
        if ((probe.kind == "patch" || probe.kind == "cavity" || probe.kind == "taylor-green") &&
            !(value(probe.side) > 0 && std::isfinite(value(probe.side))))
            say(errors, "probes.{}.side = {} must be finite and above 0 m", k, probe.side);
        if (probe.kind == "channel") {
            if (!(value(probe.gap) > 0 && std::isfinite(value(probe.gap))))
                say(errors, "probes.{}.gap = {} must be finite and above 0 m", k, probe.gap);
            if (probe.flow == "from-rest" && c.fluid.rheology != "newtonian")
                say(errors,
                    "probes.{}.flow = 'from-rest' is known for fluid.rheology = 'newtonian' only, not '{}': use "
                    "'steady'",
                    k, c.fluid.rheology);
            if (rheology_of(c).model == Rheology::Model::newtonian && rheology_of(c).viscosity == 0)
                say(errors, "probes.{}: a channel needs a viscous liquid, but fluid.viscosity is 0 Pa s", k);
        }
        if (probe.kind == "mode" && c.fluid.surface_tension == 0)
            say(errors, "probes.{}: a mode oscillates by surface tension, but fluid.surface_tension is 0 N/m: set it",
                k);
        if (probe.kind == "static-drop" && c.fluid.surface_tension == 0)
            say(errors,
                "probes.{}: Laplace's pressure is that of surface tension, but fluid.surface_tension is 0 N/m: set it",
                k);
        if (probe.kind == "column" && (c.fluid.surface_tension == 0 || c.domain.periodic != "x"))
            say(errors,
                "probes.{}: a column along x breaks up by surface tension and goes on at both ends: set "
                "fluid.surface_tension, and domain.periodic = 'x'",
                k);
        bool const is_of_free_liquid =
            probe.kind == "drop" || probe.kind == "mode" || probe.kind == "static-drop" || probe.kind == "pieces";
        if ((is_of_free_liquid || probe.kind == "patch") && periodic_box<D>(c).any())
            say(errors, "probes.{}: a probe of kind {} sees no liquid across domain.periodic", k, probe.kind);
        if (probe.kind == "patch" && !c.walls.empty()) say(errors, "probes.{}: a patch is liquid without walls", k);
        if (probe.kind == "patch" && !std::isfinite(value(probe.angular_velocity)))
            say(errors, "probes.{}.angular_velocity = {} must be finite", k, probe.angular_velocity);
    }
    for (std::size_t k = 0; k < c.probes.size(); ++k) {
        check_wall_probe(c, k, errors);
        if (c.walls.empty() || (c.probes[k].kind != "sensor" && c.probes[k].kind != "impact")) continue;
        Vector<double, D> at;
        for (int a = 0; a < D; ++a) at[a] = c.probes[k].at[static_cast<std::size_t>(a)];
        auto const nearest = Solid<D>(c).deepest(at);
        if (double const away = std::fabs(nearest.depth); away > c.particles.spacing)
            say(errors, "probes.{}.at = [{}] is {:.4g} m from the surface of the nearest wall: a sensor is on it", k,
                fmt::join(c.probes[k].at, ", "), away);
        if (moves(c.walls[nearest.wall]))
            say(errors, "probes.{}: a sensor does not go along with its wall, and walls.{} moves: leave it away", k,
                nearest.wall);
    }
    auto const has_profile = [](ProbeKeys const& probe) { return probe.kind == "channel" || probe.kind == "cavity"; };
    if (c.time.settled > 0 && std::none_of(c.probes.begin(), c.probes.end(), has_profile))
        say(errors, "time.settled = {} wants a probe with a profile, of kind channel or cavity", c.time.settled);
    if (!errors.empty()) return;
    auto const standard = standard_columns(D);
    std::set<std::string> columns(standard.begin(), standard.end());
    for (char const* const reading :
         {"singular_matrices", "solver_iterations", "divergence_max", "viscous_iterations", "wall_force_x",
          "wall_force_y", "wall_force_z", "surface_energy", "surface_content", "surface_energy_jumps", "tension_work",
          "dissipated_energy", "compressive_energy"})
        columns.insert(reading);  // of the schemes
    for (auto const& probe : make_probes<D>(c))
        for (std::string const& column : probe->columns())
            if (!columns.insert(column).second)
                say(errors,
                    "the column '{}' of the series is there already: give the probe, or its wall, another name, or "
                    "leave it "
                    "away",
                    column);
}

template <int D>
void check_initial_state(Case const& c, Errors& errors) {
    auto const seeds = fill<D>(c);
    if (seeds.size() == 0) {
        say(errors, "the shapes hold no particle at particles.spacing = {} m: use a smaller spacing",
            c.particles.spacing);
        return;
    }
    auto const state = initial_state(c, seeds, WallSeeds<D>{});
    if (c.initial.frame) check_initial_frame<D>(c, state.beyond, seeds.size(), errors);
    std::string const from = fmt::format("initial.from = '{}'", c.initial.from);
    double const fastest = std::sqrt(state.fastest2);
    if (!std::isfinite(fastest))
        say(errors, "initial.velocity = [{}] is not finite at every particle", fmt::join(c.initial.velocity, ", "));
    else if (c.method.scheme == "weakly-compressible" && fastest >= c.fluid.sound_speed)
        say(errors,
            "fluid.sound_speed = {} m/s, but {} is up to {:.4g} m/s{}: the flow must "
            "stay below the sound speed, at best a tenth of it; use {:.4g} m/s",
            c.fluid.sound_speed, c.initial.frame ? "the velocity of " + from : "initial.velocity", fastest,
            c.walls.empty() ? " from its mean" : "", 10 * fastest);
    if (!state.density_is_possible)
        say(errors,
            "{} leaves no positive finite density at every particle with fluid.sound_speed = "
            "{} m/s: use a larger sound speed",
            c.initial.frame ? "the pressure of " + from : "initial.pressure = " + c.initial.pressure,
            c.fluid.sound_speed);
    for (std::string const& text : c.fluid.body_force) {
        Formula force(text, c.parameters);
        auto const finite = [&](auto const& x) { return std::isfinite(force(x, 0)); };
        if (!std::all_of(seeds.position.begin(), seeds.position.end(), finite))
            say(errors, "fluid.body_force: {} is not finite at every particle at t = 0", text);
    }
}

/// A fixed step is refused beyond the least limit of the scheme that is known before the flow is.
void check_step(Case const& c, double sound, Errors& errors) {
    struct Limit {
        double step;  // [s]
        double safe;  // share of it that is advised; below 1 even where it is exact, since the advice is rounded
        std::string formula, more;
    };
    double const dx = c.particles.spacing, h = c.method.support * dx / 3;
    bool const implicit = c.method.viscous_step == "implicit";
    double const thickest = implicit ? 0 : rheology_of(c).largest_viscosity();
    std::string const length = fmt::format("h, a third of the kernel's radius, is {:.3g} m", h);
    Limit least{sound, 0.25, "h/c", length};
    auto const vote = [&](Limit const& limit) {
        if (limit.step < least.step) least = limit;
    };
    vote({h * h * c.fluid.density / thickest, 0.125, "h^2/nu", length});  // infinite without viscosity
    vote({capillary_step({.tension = c.fluid.surface_tension, .spacing = dx}, c.fluid.density), 0.99,
          "sqrt(rho dx^3/(4 pi sigma))", "that of capillary waves as short as the spacing dx"});
    if (c.time.step > least.step)
        say(errors,
            "time.step = {} s is beyond the largest stable step, {} = {:.3g} s ({}): use 'auto' or at most {:.3g} s{}",
            c.time.step, least.formula, least.step, least.more, least.safe * least.step,
            least.formula == "h^2/nu" ? ", or method.viscous_step = 'implicit'" : "");
}

void check_times(Case const& c, Errors& errors) {
    double const h = c.method.support * c.particles.spacing / 3,
                 sound = c.method.scheme == "projection" ? INFINITY : h / c.fluid.sound_speed;
    check_step(c, sound, errors);
    double const steps = c.time.step > 0 ? c.time.end / c.time.step : c.time.end / sound;
    if (steps > most_steps)
        say(errors, "time.end = {} s needs {:.1e} steps of {:.3g} s; at most {:.0e} are allowed", c.time.end, steps,
            c.time.end / steps, most_steps);
    auto const check_interval = [&](std::string const& key, double every, double most, std::string const& things) {
        if (c.time.end / every > most)
            say(errors, "{} = {} s would write {:.1e} {}; at most {:.0e} are allowed: use {:.2g} s or more", key, every,
                c.time.end / every, things, most, c.time.end / most);
    };
    if (c.output.frames) check_interval("output.every", c.output.every, most_frames, "frames");
    check_interval("output.series_every", c.output.series_every, most_rows, "rows");
}

template <int D>
void check(Case const& c, Errors& errors) {
    if (c.method.viscous_force == "morris" && c.method.gradient == "cph")
        say(errors,
            "method.viscous_force = 'morris' goes with method.gradient = 'sph' or 'fpm', not 'cph': use 'stress'");
    if (c.method.viscous_force == "morris" && c.method.gradient == "fpm" && c.fluid.rheology != "newtonian")
        say(errors,
            "method.viscous_force = 'morris' with method.gradient = 'fpm' goes with fluid.rheology = 'newtonian' only, "
            "not '{}': use 'stress', or 'sph'",
            c.fluid.rheology);
    double const radius = c.method.support * c.particles.spacing;
    if (c.method.precision == "mixed" && (radius < least_mixed_radius || radius > 1 / least_mixed_radius))
        say(errors,
            "method.precision = 'mixed' holds lengths of {:.0e} to {:.0e} m, but the kernel's radius is {:.3g} m "
            "(support "
            "{} times spacing {} m): use 'double'",
            least_mixed_radius, 1 / least_mixed_radius, radius, c.method.support, c.particles.spacing);
    auto const projects_with = [&](std::string const& key, std::string const& found, std::string const& only) {
        if (c.method.scheme == "projection" && found != only)
            say(errors, "{} = '{}' is not for method.scheme = 'projection', which knows '{}' only", key, found, only);
    };
    projects_with("method.gradient", c.method.gradient, "fpm");
    projects_with("method.precision", c.method.precision, "double");
    projects_with("method.viscous_force", c.method.viscous_force, "stress");
    projects_with("time.stepping", c.time.stepping, "predictor-corrector");
    projects_with("time.position_update", c.time.position_update, "mean-velocity");
    projects_with("initial.pressure", c.initial.pressure, "0");
    bool const thesis = c.method.scheme == "projection" && c.method.pressure_operator == "thesis";
    if (thesis && c.surface.pressure == "free" && !c.method.lattice_diagonal)
        say(errors,
            "surface.pressure = 'free' leaves the pressure of the thesis's matrix open by a constant, and it has no "
            "solution: use 'mirrored' or 'zero', or method.lattice_diagonal = true");
    bool const on_boundary = c.fluid.surface_tension > 0 && c.surface.tension_force == "boundary";
    if (c.method.shifting == "conserving" && !on_boundary)
        say(errors,
            "method.shifting = 'conserving' keeps what a tension on the boundary acts on: it needs "
            "fluid.surface_tension and surface.tension_force = 'boundary'");
    if (c.time.stepping == "symplectic-euler" && c.time.position_update != "mean-velocity")
        say(errors,
            "time.position_update = '{}' is of time.stepping = 'predictor-corrector'; 'symplectic-euler' moves "
            "particles "
            "by their new velocity: leave it away",
            c.time.position_update);
    if (c.method.central_viscosity.active() && (c.method.gradient != "fpm" || c.method.viscous_force != "stress" ||
                                                c.method.viscous_step != "explicit" || !c.walls.empty()))
        say(errors,
            "method.central_share is for method.gradient = 'fpm' with viscous_force = 'stress', viscous_step = "
            "'explicit' and no walls, but here are '{}', '{}', '{}' and {} walls: change that, or leave it away",
            c.method.gradient, c.method.viscous_force, c.method.viscous_step, c.walls.size());
    bool const closed = !c.walls.empty() || c.domain.periodic != "none";
    bool const fits = (c.fluid.surface_tension > 0 && !on_boundary) || c.method.shifting == "sun" ||
                      (thesis && c.surface.pressure != "free");
    if (fits || on_boundary || (closed && c.method.shifting != "none")) {
        if (2 * c.surface.coverage_radius > c.method.support)
            say(errors,
                "surface.coverage_radius = {} is above half of method.support = {}: neighbours are not known that far",
                c.surface.coverage_radius, c.method.support);
        if (fits && c.surface.fit_width > c.method.support)
            say(errors, "surface.fit_width = {} is above method.support = {}: neighbours are not known that far",
                c.surface.fit_width, c.method.support);
    }
    if (c.method.scheme == "projection" && c.method.pressure_support > c.method.support)
        say(errors, "method.pressure_support = {} is above method.support = {}: neighbours are known up to that only",
            c.method.pressure_support, c.method.support);
    check_names(c, errors);
    check_rheology(c, errors);
    check_times(c, errors);
    check_domain<D>(c, errors);
    check_probes<D>(c, errors);
    Errors impossible;  // to fill with particles
    check_shapes<D>(c, impossible);
    check_shells(c, impossible);
    errors.insert(errors.end(), impossible.begin(), impossible.end());
    if (impossible.empty()) check_initial_state<D>(c, errors);
    if (errors.empty()) check_sliding<D>(c, errors);
}

}  // namespace

void check_physics(Case const& c, std::string const& file) {
    Errors errors;
    if (c.dimension == 2) check<2>(c, errors);
    else check<3>(c, errors);
    if (errors.empty()) return;
    for (std::string& error : errors) error = file + ": " + error;
    throw CaseError(fmt::format("{}", fmt::join(errors, "\n")));
}

}  // namespace coronet
