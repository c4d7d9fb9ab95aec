// SPDX-License-Identifier: BSD-3-Clause

// The one list of keys: order, meaning, unit, range and default of everything a case file may say.

#include <algorithm>

#include "coronet/cases/boundaries.hpp"
#include "coronet/cases/case.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/probe_keys.hpp"
#include "coronet/kernels/kernel.hpp"

namespace coronet {

namespace {

template <class... Terms>
void describe_terms(Keys& keys, Sum<Terms...>& sum) {
    [[maybe_unused]] auto const show = [&]<class T>(T& term) {
        if constexpr (requires { term.describe(keys); }) term.describe(keys);
    };
    (show(static_cast<Terms&>(sum)), ...);
}

void describe_shape(Keys& keys, Shape& shape, std::string const& path, int dimension) {
    auto const wants = [&](std::string const& kind) { return keys.everything() || shape.kind == kind; };
    Keys::Words kinds{dimension == 2 ? "disc" : "ball", "box", "ellipse", "drop"};
    if (keys.everything()) kinds.insert(kinds.begin(), "ball");
    if (dimension == 3 || keys.everything()) kinds.push_back("column");
    if (dimension == 3 && shape.kind == "disc") shape.kind = "ball";
    std::vector<double> const origin(static_cast<std::size_t>(dimension), 0.0);
    std::vector<double> const unit(static_cast<std::size_t>(dimension), 1.0);

    keys.choice(
        {.path = path + ".kind",
         .meaning =
             "form of the liquid; an ellipse in 3D is an ellipsoid, a drop a disc or ball with the wave of `drop`, a "
             "column a cylinder along the x axis with the wave of `column`",
         .required = true},
        shape.kind, kinds);
    if (shape.centre.empty()) shape.centre = origin;
    keys.numbers({.path = path + ".centre", .unit = "m", .meaning = "its centre"}, shape.centre, dimension);
    if (wants("disc") || wants("ball") || wants("drop") || wants("column"))
        keys.number({.path = path + ".radius",
                     .unit = "m",
                     .meaning = "of a disc or ball; of a drop, that of the disc (ball) with its area (volume), of a "
                                "column that of the cylinder",
                     .above = 0},
                    shape.radius);
    if (wants("column"))
        keys.number({.path = path + ".length", .unit = "m", .meaning = "of a column", .above = 0}, shape.length);
    if (wants("box")) {
        if (shape.size.empty()) shape.size = unit;
        keys.numbers({.path = path + ".size", .unit = "m", .meaning = "edges of a box", .above = 0}, shape.size,
                     dimension);
    }
    if (wants("ellipse")) {
        if (shape.semi_axes.empty()) shape.semi_axes = unit;
        keys.numbers({.path = path + ".semi_axes", .unit = "m", .meaning = "of an ellipse", .above = 0},
                     shape.semi_axes, dimension);
    }
    keys.number({.path = path + ".rotation", .unit = "degrees", .meaning = "turn about its centre, in the x-y plane"},
                shape.rotation);
    keys.tables(
        {.path = path + ".cuts", .meaning = "half-planes taken away from the shape"}, shape.cuts.size(),
        [&](std::size_t n) { shape.cuts.resize(n); },
        [&](std::size_t k, std::string const& cut) {
            if (shape.cuts[k].point.empty()) shape.cuts[k].point = origin;
            keys.numbers({.path = cut + ".point", .unit = "m", .meaning = "a point of the cutting plane"},
                         shape.cuts[k].point, dimension);
            keys.numbers(
                {.path = cut + ".normal", .unit = "-", .meaning = "points to the side taken away", .required = true},
                shape.cuts[k].normal, dimension);
        });
}

/// The wave on the shapes of kind drop.
void describe_drop(Keys& keys, Case& c) {
    auto const is_drop = [](Shape const& shape) { return shape.kind == "drop"; };
    if (!keys.everything() && std::none_of(c.shapes.begin(), c.shapes.end(), is_drop)) return;
    keys.number(
        {.path = "drop.amplitude",
         .unit = "-",
         .meaning = "a of the radius 1 + a cos(n theta), in 3D 1 + a P_n(cos theta) about the x axis, of shapes "
                    "of kind drop",
         .at_least = -0.9,
         .at_most = 0.9},
        c.drop.amplitude);
    keys.integer({.path = "drop.mode", .unit = "-", .meaning = "n of the same", .at_least = 2, .at_most = 100},
                 c.drop.mode);
    for (Shape& shape : c.shapes) {
        if (!is_drop(shape)) continue;
        shape.amplitude = c.drop.amplitude;
        shape.mode = c.drop.mode;
    }
}

/// The wave on the shapes of kind column.
void describe_column(Keys& keys, Case& c) {
    auto const is_column = [](Shape const& shape) { return shape.kind == "column"; };
    if (!keys.everything() && std::none_of(c.shapes.begin(), c.shapes.end(), is_column)) return;
    keys.number({.path = "column.amplitude",
                 .unit = "-",
                 .meaning = "a of the radius 1 + a cos(2 pi n x/length) of shapes of kind column, x from their middle",
                 .at_least = -0.9,
                 .at_most = 0.9},
                c.column.amplitude);
    keys.integer({.path = "column.waves", .unit = "-", .meaning = "n of the same", .at_least = 1, .at_most = 100},
                 c.column.waves);
    for (Shape& shape : c.shapes) {
        if (!is_column(shape)) continue;
        shape.amplitude = c.column.amplitude;
        shape.mode = c.column.waves;
    }
}

void describe_shifting(Keys& keys, Case& c) {
    auto& m = c.method;
    keys.choice(
        {.path = "method.shifting",
         .meaning = "keeps particles evenly spread: xu (spreads a free surface), jahanbakhsh (pushes apart what "
                    "is nearer than a spacing), sun (moves nothing out of a free surface, so it keeps volume), "
                    "conserving (with a tension on the boundary: keeps momentum, its moment, and what "
                    "the surface holds)"},
        m.shifting, {"none", "xu", "jahanbakhsh", "sun", "conserving"});
    keys.number({.path = "method.shift_range",
                 .unit = "spacings",
                 .meaning = "of conserving: what is nearer is moved apart",
                 .at_least = 0.1,
                 .at_most = 1.5},
                m.shift_range);
    if (m.shifting_coefficient == 0 && !keys.everything()) m.shifting_coefficient = m.shifting == "sun" ? 1 : 0.1;
    keys.number({.path = "method.shifting_coefficient",
                 .unit = "-",
                 .meaning = "K of the shift, K times its vector times the way of the fastest particle in a step; by "
                            "default 1 for sun and 0.1 for the others",
                 .above = 0,
                 .at_most = 10},
                m.shifting_coefficient);
}

/// Shown for every scheme, so that a case can change its scheme by one key.
void describe_projection(Keys& keys, Case& c) {
    auto& m = c.method;
    keys.choice(
        {.path = "method.viscous_step",
         .meaning = "explicit, whose length viscosity limits; or implicit, of any length, for stiff liquids: with the "
                    "projection, or with viscous_force morris"},
        m.viscous_step, {"explicit", "implicit"});
    keys.choice({.path = "method.pressure_operator",
                 .meaning = "consistent: force and divergence are each other's transpose, an exact projection; thesis: "
                            "Lobo (2011), an approximate one"},
                m.pressure_operator, {"consistent", "thesis"});
    auto const names = kernel_names();
    if (m.pressure_kernel.empty()) m.pressure_kernel = m.kernel;
    keys.choice({.path = "method.pressure_kernel",
                 .meaning = "of the pressure and the divergence; by default that of everything else"},
                m.pressure_kernel, {names.begin(), names.end()});
    if (m.pressure_support == 0) m.pressure_support = m.support;
    keys.number({.path = "method.pressure_support",
                 .unit = "spacings",
                 .meaning = "radius of that kernel, at most method.support, the default",
                 .at_least = 1.5,
                 .at_most = 10},
                m.pressure_support);
    keys.choice({.path = "method.preconditioner", .meaning = "of the conjugate gradients that solve for the pressure"},
                m.preconditioner, {"jacobi", "multigrid"});
    keys.number({.path = "method.tolerance",
                 .unit = "-",
                 .meaning = "of each solve: the residual over the right-hand side",
                 .above = 0,
                 .at_most = 0.1},
                m.tolerance);
    keys.integer(
        {.path = "method.most_iterations", .unit = "-", .meaning = "a solve that takes more has failed", .at_least = 1},
        m.most_iterations);
    keys.number({.path = "method.compact_share",
                 .unit = "-",
                 .meaning = "of a compact Laplacian in the consistent operator, against checkerboards; with 0 the "
                            "projection is exact",
                 .at_least = 0,
                 .at_most = 0.5},
                m.compact_share);
    keys.flag({.path = "method.lattice_diagonal",
               .meaning = "of the thesis's matrix: no diagonal less than in a lattice, which holds the constant"},
              m.lattice_diagonal);
}

void describe_surface(Keys& keys, Case& c) {
    auto& s = c.surface;
    keys.choice({.path = "surface.tension_force",
                 .meaning = "boundary: minus the derivative of sigma times the length (area) of the surface, which "
                            "conserves momentum; curvature: that of fits, as Lobo (2011)"},
                s.tension_force, {"boundary", "curvature"});
    keys.choice({.path = "surface.pressure",
                 .meaning = "of the thesis's matrix: nothing special, zero at the surface particles, or mirrored at a "
                            "surface half a spacing outside of them"},
                c.surface.pressure, {"free", "zero", "mirrored"});
    keys.number({.path = "surface.coverage_radius",
                 .unit = "spacings",
                 .meaning = "a particle is of the surface if its circle of this radius is not covered by others",
                 .at_least = 0.75,
                 .at_most = 5},
                s.coverage_radius);
    keys.number({.path = "surface.fit_width",
                 .unit = "spacings",
                 .meaning = "surface particles within it give normal and curvature",
                 .at_least = 1.5,
                 .at_most = 5},
                s.fit_width);
    keys.choice({.path = "surface.fit_weights",
                 .meaning = "compact: falling to 0 at the width, restoring at every wavelength; none: as Lobo (2011)"},
                s.fit_weights, {"compact", "none"});
    keys.flag({.path = "surface.remove_mean_force",
               .meaning = "take the mean of the tension off every surface particle: keeps momentum, not its moment"},
              s.remove_mean_force);
}

}  // namespace

void describe(Keys& keys, Case& c) {
    keys.text({.path = "name", .meaning = "names the case and, by default, the directory of the run", .required = true},
              c.name);
    keys.text({.path = "title", .meaning = "one line on what it shows"}, c.title);
    keys.integer({.path = "dimension", .unit = "-", .meaning = "2 or 3", .at_least = 2, .at_most = 3, .required = true},
                 c.dimension);
    int const D = c.dimension;
    std::vector<std::string> const none(static_cast<std::size_t>(D), "0");

    keys.named_numbers({.path = "parameters", .meaning = "numbers that formulas may use by name"}, c.parameters);

    keys.tables(
        {.path = "shapes", .meaning = "the liquid at the start: the union of these shapes", .required = true},
        c.shapes.size(), [&](std::size_t n) { c.shapes.resize(n); },
        [&](std::size_t k, std::string const& path) { describe_shape(keys, c.shapes[k], path, D); });
    describe_drop(keys, c);
    describe_column(keys, c);
    describe_boundaries(keys, c);

    auto& p = c.particles;
    keys.number({.path = "particles.spacing",
                 .unit = "m",
                 .meaning = "distance between lattice neighbours",
                 .above = 0,
                 .required = true},
                p.spacing);
    keys.choice(
        {.path = "particles.lattice",
         .meaning =
             "how particles are laid; hexagonal is face-centred cubic in 3D, shells are concentric, for discs, balls "
             "or drops of one radius, or for a column"},
        p.lattice, {"square", "hexagonal", "shells"});
    keys.choice({.path = "particles.origin", .meaning = "a particle (node) or a cell corner at x = 0"}, p.origin,
                {"node", "cell"});
    keys.number({.path = "particles.rotation",
                 .unit = "degrees",
                 .meaning = "turn of the lattice about x = 0 in the x-y plane"},
                p.rotation);
    keys.number({.path = "particles.jitter",
                 .unit = "-",
                 .meaning = "each coordinate is moved by up to this share of the spacing, at random",
                 .at_least = 0,
                 .at_most = 0.5},
                p.jitter);
    keys.integer({.path = "particles.seed", .unit = "-", .meaning = "of the random numbers", .at_least = 0}, p.seed);

    if (c.initial.velocity.empty()) c.initial.velocity = none;
    keys.formulas({.path = "initial.velocity", .unit = "m/s", .meaning = "velocity at t = 0"}, c.initial.velocity, D);
    keys.formula({.path = "initial.pressure",
                  .unit = "Pa",
                  .meaning = "pressure at t = 0, from which density follows; of the weakly compressible scheme"},
                 c.initial.pressure);
    keys.text({.path = "initial.from",
               .meaning = "a frame of another run, whose velocity and pressure stand in place of these formulas; its "
                          "path from the folder of the case"},
              c.initial.from);

    auto& m = c.method;
    keys.choice({.path = "method.scheme", .meaning = "how the equations are solved"}, m.scheme,
                {"weakly-compressible", "projection"});
    keys.choice({.path = "method.gradient",
                 .meaning = "sph: plain; fpm: exact for linear fields; cph: fpm near the free surface, sph inside"},
                m.gradient, {"sph", "cph", "fpm"});
    keys.choice(
        {.path = "method.viscous_force",
         .meaning =
             "stress: from the velocity gradient; morris: between velocities, with gradient sph, in one sweep, or "
             "fpm"},
        m.viscous_force, {"stress", "morris"});
    auto const names = kernel_names();
    keys.choice({.path = "method.kernel", .meaning = "smoothing kernel"}, m.kernel, {names.begin(), names.end()});
    keys.number({.path = "method.support",
                 .unit = "spacings",
                 .meaning = "radius of the kernel",
                 .at_least = 1.5,
                 .at_most = 10},
                m.support);
    keys.number_or({.path = "method.skin",
                    .unit = "spacings",
                    .meaning = "margin of the neighbour lists; auto tunes it on the way. It changes the speed, and "
                               "with cph how often the zones are marked",
                    .above = 0,
                    .at_most = 5},
                   m.skin, "auto");
    keys.choice(
        {.path = "method.precision",
         .meaning = "of the pair sums: all in double; or pairs in float, with exact differences of position, and "
                    "everything that is kept in double"},
        m.precision, {"double", "mixed"});
    m.central_viscosity.describe(keys);
    describe_terms(keys, m.pair_terms);
    describe_shifting(keys, c);
    describe_projection(keys, c);
    describe_fluid(keys, c);
    describe_surface(keys, c);

    keys.number({.path = "time.end", .unit = "s", .meaning = "simulated time", .above = 0, .required = true},
                c.time.end);
    keys.number_or(
        {.path = "time.step", .unit = "s", .meaning = "time step, or auto: as long as is stable", .above = 0},
        c.time.step, "auto");
    keys.number(
        {.path = "time.courant",
         .unit = "-",
         .meaning = "an automatic step is at most this times h/c (weakly-compressible; c the sound speed) or h/v "
                    "(projection; v the largest speed from the mean), h = a third of the kernel's radius",
         .above = 0,
         .at_most = 1},
        c.time.courant);
    keys.number(
        {.path = "time.settled",
         .unit = "-",
         .meaning = "end before time.end once no profile differs from that at 4/5 of the time by more than this "
                    "share of its root mean square; 0: never",
         .at_least = 0,
         .at_most = 0.1},
        c.time.settled);
    keys.choice(
        {.path = "time.stepping",
         .meaning = "predictor-corrector: two evaluations a step; symplectic-euler: one, density, then velocity, "
                    "then position, each with the new values of those before"},
        c.time.stepping, {"predictor-corrector", "symplectic-euler"});
    keys.choice(
        {.path = "time.position_update",
         .meaning = "mean-velocity keeps angular momentum to round-off; midpoint-velocity is Fang's printed form"},
        c.time.position_update, {"mean-velocity", "midpoint-velocity"});

    if (c.output.every == 0) c.output.every = c.time.end / 10;
    keys.number({.path = "output.every",
                 .unit = "s",
                 .meaning = "time between frames; by default a tenth of the end",
                 .above = 0},
                c.output.every);
    if (c.output.series_every == 0) c.output.series_every = c.time.end / 200;
    keys.number({.path = "output.series_every",
                 .unit = "s",
                 .meaning = "time between rows of the series; by default a 200th of the end",
                 .above = 0},
                c.output.series_every);
    keys.flag({.path = "output.frames", .meaning = "whether frames are written"}, c.output.frames);

    keys.tables(
        {.path = "probes", .meaning = "further columns of the series and measures of the summary"}, c.probes.size(),
        [&](std::size_t n) { c.probes.resize(n); },
        [&](std::size_t k, std::string const& path) { describe_probe(keys, c.probes[k], path, D); });
}

}  // namespace coronet
