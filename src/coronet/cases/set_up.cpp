// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/set_up.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/cases/fluid.hpp"
#include "coronet/cases/formula.hpp"
#include "coronet/cases/frame_flow.hpp"
#include "coronet/cases/lattice.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/cases/wall_motion.hpp"
#include "coronet/schemes/incompressible.hpp"
#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

namespace {

std::vector<Formula> formulas(std::vector<std::string> const& texts, Case const& c) {
    std::vector<Formula> list;
    for (std::string const& text : texts) list.emplace_back(text, c.parameters);
    return list;
}

/// The case's body force as the scheme wants it; empty where the case has none.
template <int D>
std::function<void(double, View<D> const&, std::size_t, std::size_t)> body_force(Case const& c) {
    auto const zero = [](std::string const& text) { return text == "0"; };
    if (std::all_of(c.fluid.body_force.begin(), c.fluid.body_force.end(), zero)) return {};
    auto force = std::make_shared<std::vector<Formula>>(formulas(c.fluid.body_force, c));
    return [force](double time, View<D> const& view, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            auto const x = view.template get<Position>(i);
            for (int k = 0; k < D; ++k) view.template at<Acceleration>(k)[i] += (*force)[k](x, time);
        }
    };
}

/// Velocity and pressure at t = 0, seed after seed: of the case's frame, or of its formulas.
template <int D>
std::vector<typename FrameFlow<D>::Value> initial_flow(Case const& c, Seeds<D> const& seeds) {
    std::vector<typename FrameFlow<D>::Value> flow(seeds.size());
    if (c.initial.frame) {
        FrameFlow<D> const frame(*c.initial.frame, periodic_box<D>(c));
        for_each(seeds.size(), [&](std::size_t i) { flow[i] = frame.at(seeds.position[i]); });
        return flow;
    }
    auto velocity = formulas(c.initial.velocity, c);
    Formula pressure(c.initial.pressure, c.parameters);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        for (int k = 0; k < D; ++k) flow[i].velocity[k] = velocity[k](seeds.position[i], 0);
        flow[i].pressure = pressure(seeds.position[i], 0);
    }
    return flow;
}

}  // namespace

EquationOfState equation_of_state(Case const& c) {
    return {c.fluid.equation_of_state == "tait" ? EquationOfState::Kind::tait : EquationOfState::Kind::linear,
            c.fluid.density, c.fluid.sound_speed, c.fluid.tait_exponent};
}

template <int D>
InitialState<D> initial_state(Case const& c, Seeds<D> const& seeds, WallSeeds<D> const& walls) {
    InitialState<D> state{Particles<D>(seeds.size(), walls.size())};
    state.particles.allocate(Fields<Position, Velocity, Density, Mass, Surface>{});
    auto const view = state.particles.view();
    auto const eos = equation_of_state(c);
    bool const incompressible = c.method.scheme == "projection";
    auto const flow = initial_flow(c, seeds);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        double const rho = incompressible ? c.fluid.density : eos.density(flow[i].pressure);
        view.template set<Position>(i, seeds.position[i]);
        view.template set<Velocity>(i, flow[i].velocity);
        view.template set<Density>(i, rho);
        view.template set<Mass>(i, rho * seeds.volume);
        view.template set<Surface>(i, seeds.surface[i]);
        state.beyond += flow[i].beyond;
        state.density_is_possible = state.density_is_possible && std::isfinite(rho) && rho > 0;
    }
    if (walls.size() > 0) state.particles.allocate(Fields<WallVelocity, ToMirror, Slip, WallNumber, WallForce>{});
    auto const with_walls = state.particles.view();
    for (std::size_t k = 0; k < walls.size(); ++k) {
        std::size_t const w = state.particles.begin(Role::wall) + k, mirror = state.particles.begin(Role::mirror) + k;
        with_walls.template set<Position>(w, walls.position[k]);
        with_walls.template set<Position>(mirror, walls.position[k] + walls.to_mirror[k]);
        with_walls.template set<ToMirror>(w, walls.to_mirror[k]);
        with_walls.template set<Slip>(w, c.walls[walls.wall[k]].slip == "free");
        with_walls.template set<WallNumber>(w, static_cast<double>(walls.wall[k]));
        with_walls.template set<Mass>(w, c.fluid.density * seeds.volume);
    }
    // Walls, which are as they are, make a common velocity one that counts.
    auto const mean =
        (c.walls.empty() ? 1.0 / static_cast<double>(std::max<std::size_t>(seeds.size(), 1)) : 0.0) *
        sum_over(seeds.size(), Vector<double, D>{}, [&](std::size_t i) { return view.template get<Velocity>(i); });
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        double const speed2 = norm2(view.template get<Velocity>(i) - mean);
        state.fastest2 = std::isfinite(speed2) ? std::max(state.fastest2, speed2) : INFINITY;
    }
    return state;
}

namespace {

SurfaceSettings surface_settings(Case const& c) {
    double const dx = c.particles.spacing;
    return {
        .tension = c.fluid.surface_tension,
        .force = c.surface.tension_force == "boundary" ? TensionForce::boundary : TensionForce::curvature,
        .spacing = dx,
        .volume = c.dimension == 2 ? Lattice<2>(c).volume() : Lattice<3>(c).volume(),
        .coverage_radius = c.surface.coverage_radius * dx,
        .fit = {c.surface.fit_width * dx, c.surface.fit_weights == "compact" ? FitWeights::compact : FitWeights::none},
        .remove_mean_force = c.surface.remove_mean_force};
}

ShiftingSettings shifting(Case const& c) {
    auto const& name = c.method.shifting;
    return {name == "xu"            ? ShiftVector::xu
            : name == "jahanbakhsh" ? ShiftVector::jahanbakhsh
            : name == "sun"         ? ShiftVector::sun
                                    : ShiftVector::none,
            c.method.shifting_coefficient, c.particles.spacing, surface_settings(c),
            std::any_of(c.walls.begin(), c.walls.end(), moves)};
}

template <int D>
Vector<double, D> gravity(Case const& c) {
    Vector<double, D> g;
    for (int k = 0; k < D; ++k) g[k] = c.fluid.gravity[k];
    return g;
}

template <int D>
std::unique_ptr<Scheme<D>> weakly_compressible(Case const& c) {
    typename WeaklyCompressible<D>::Settings s;
    double const dx = c.particles.spacing;
    s.kernel = make_kernel(c.method.kernel, D, c.method.support * dx);
    s.skin = c.method.skin * dx;
    s.precision = c.method.precision == "mixed" ? Precision::mixed : Precision::full;
    s.gradient = c.method.gradient == "sph"   ? Gradient::sph
                 : c.method.gradient == "cph" ? Gradient::cph
                                              : Gradient::fpm;
    s.viscous_force = c.method.viscous_force == "morris" ? ViscousForce::morris : ViscousForce::stress;
    s.stepping = c.time.stepping == "symplectic-euler" ? Stepping::symplectic_euler : Stepping::predictor_corrector;
    s.shifting = shifting(c);
    s.shift_range = c.method.shifting == "conserving" ? c.method.shift_range * dx : 0;
    s.position_update =
        c.time.position_update == "mean-velocity" ? PositionUpdate::mean_velocity : PositionUpdate::midpoint_velocity;
    s.courant = c.time.courant;
    s.equation_of_state = equation_of_state(c);
    s.liquid.rheology = rheology_of(c);
    s.central_viscosity = c.method.central_viscosity;
    s.pair_terms = c.method.pair_terms;
    s.surface = surface_settings(c);
    s.gravity = gravity<D>(c);
    s.body_force = body_force<D>(c);
    auto const walls = fill_walls<D>(c);
    s.box = periodic_box<D>(c);
    s.wall_contact = dx / std::sqrt(2);
    s.lattice_slope_moment = lattice_slope_moment<D>(c, s.kernel);
    s.implicit_viscosity = c.method.viscous_step == "implicit";
    s.solve = {c.method.tolerance, c.method.most_iterations};
    s.wall_motion = wall_motion<D>(c, walls);
    return std::make_unique<WeaklyCompressible<D>>(s, initial_state(c, fill<D>(c), walls).particles);
}

template <int D>
std::unique_ptr<Scheme<D>> incompressible(Case const& c) {
    using Scheme = Incompressible<D>;
    double const dx = c.particles.spacing, support = c.method.support * dx;
    typename Scheme::Settings s;
    s.kernel = make_kernel(c.method.kernel, D, support);
    s.pressure_kernel = make_kernel(c.method.pressure_kernel, D, c.method.pressure_support * dx);
    s.skin = c.method.skin * dx;
    s.liquid.rheology = rheology_of(c);
    s.density = c.fluid.density;
    s.sound_speed = c.fluid.sound_speed;
    s.central_viscosity = c.method.central_viscosity;
    s.pair_terms = c.method.pair_terms;
    s.viscous_step =
        c.method.viscous_step == "implicit" ? Scheme::Viscous::implicit_step : Scheme::Viscous::explicit_step;
    s.pressure = c.method.pressure_operator == "thesis" ? Scheme::Operator::thesis : Scheme::Operator::consistent;
    s.compact_share = c.method.compact_share;
    s.thesis = {c.surface.pressure == "zero"       ? SurfacePressure::zero
                : c.surface.pressure == "mirrored" ? SurfacePressure::mirrored
                                                   : SurfacePressure::free,
                dx, c.method.lattice_diagonal};
    s.preconditioning = c.method.preconditioner == "jacobi" ? Preconditioning::jacobi : Preconditioning::multigrid;
    s.solve = {c.method.tolerance, c.method.most_iterations};
    s.surface = surface_settings(c);
    s.shifting = shifting(c);
    s.shift_range = c.method.shifting == "conserving" ? c.method.shift_range * dx : 0;
    s.courant = c.time.courant;
    s.gravity = gravity<D>(c);
    s.body_force = body_force<D>(c);
    return std::make_unique<Scheme>(s, initial_state(c, fill<D>(c), {}).particles);
}

}  // namespace

template <int D>
std::unique_ptr<Scheme<D>> make_scheme(Case const& c) {
    return c.method.scheme == "projection" ? incompressible<D>(c) : weakly_compressible<D>(c);
}

template InitialState<2> initial_state(Case const&, Seeds<2> const&, WallSeeds<2> const&);
template InitialState<3> initial_state(Case const&, Seeds<3> const&, WallSeeds<3> const&);
template std::unique_ptr<Scheme<2>> make_scheme(Case const&);
template std::unique_ptr<Scheme<3>> make_scheme(Case const&);

}  // namespace coronet
