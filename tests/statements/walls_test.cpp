// SPDX-License-Identifier: BSD-3-Clause

// What holds between walls and across periodic boundaries.

#include <gtest/gtest.h>

#include "coronet/core/parallel.hpp"
#include "coronet/schemes/weakly_compressible.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

struct ChannelOptions {
    std::string gradient = "sph", velocity = "'y', 0", lid = "'y > 0 ? 0.5 : -0.5', 0", slip = "none", periodic = "x";
    double jitter = 0, viscosity = 0.5;
    std::string viscous_force = "morris";
    std::string more = "";  ///< of the liquid
    std::string shifting = "none";
};

/// Liquid of density 1 and viscosity 0.5 in a channel of 0.6 m x 1 m, the plates at y = -0.5 and 0.5 m.
Case channel(ChannelOptions const& o) {
    std::string const walls =
        fmt::format("[[walls]]\nkind = 'box'\nsize = [10, 1]\nsurface_velocity = [{}]\nslip = '{}'\n", o.lid, o.slip);
    return read_case(
        fmt::format(
            "name = 'channel'\ndimension = 2\n"
            "[domain]\nperiodic = '{}'\nsize = [0.6, 1]\n"
            "[particles]\nspacing = 0.05\norigin = 'cell'\njitter = {}\n"
            "[initial]\nvelocity = [{}]\n"
            "[fluid]\ndensity = 1\n{}\nsound_speed = 10\n"
            "[method]\ngradient = '{}'\nviscous_force = '{}'\nkernel = 'wendland-c2'\nsupport = 3.2\nshifting = '{}'\n"
            "[time]\nend = 0.1\n"
            "[[shapes]]\nkind = 'box'\nsize = [0.6, 1]\n{}",
            o.periodic, o.jitter, o.velocity, o.more.empty() ? fmt::format("viscosity = {}", o.viscosity) : o.more,
            o.gradient, o.viscous_force, o.shifting, o.periodic == "x" ? walls : ""),
        "channel");
}

template <int D>
double largest_acceleration(Scheme<D> const& scheme) {
    auto const view = scheme.particles().view();
    return std::sqrt(max_over(scheme.particles().owned(), 0,
                              [&](std::size_t i) { return norm2(view.template get<Acceleration>(i)); }));
}

/// Position, velocity and density of the liquid, by identity.
std::vector<double> after_steps(Case const& c, int steps) {
    auto const scheme = make_scheme<2>(c);
    double const step = 5e-4;
    for (int n = 0; n < steps; ++n) {
        scheme->begin_step(n * step);
        scheme->advance(n * step, step);
    }
    auto const& particles = scheme->particles();
    std::vector<double> state(5 * particles.owned());
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        auto const row = 5 * static_cast<std::size_t>(particles.id[i]);
        for (int k = 0; k < 2; ++k) {
            state[row + k] = particles.get<Position>(k)[i];
            state[row + 2 + k] = particles.get<Velocity>(k)[i];
        }
        state[row + 4] = particles.get<Density>()[i];
    }
    return state;
}

}  // namespace

TEST(Walls, LetALinearFlowPass) {
    // The viscous forces on a particle from either side, each up to 2 nu times the slope over the spacing, cancel.
    for (std::string const gradient : {"sph", "fpm"}) {
        auto const scheme = make_scheme<2>(channel({.gradient = gradient}));
        scheme->begin_step(0);
        EXPECT_LT(largest_acceleration(*scheme), 1e-12 * 2 * 0.5 / 0.05) << gradient;
        EXPECT_EQ(scheme->particles().count(Role::wall), 2u * 12 * 3);
    }

    // A liquid whose viscosity follows the shear rate has the same viscosity everywhere.
    auto const thinning = make_scheme<2>(
        channel({.more = "rheology = 'power-law'\nconsistency = 0.5\npower_index = 0.5\nshear_rate_min = 0.1"}));
    thinning->begin_step(0);
    EXPECT_LT(largest_acceleration(*thinning), 2e-3 * 0.5 / 0.05);  // but for the slope of plain SPH on a lattice
}

TEST(Walls, PushBackWithThePressureOfALattice) {
    for (std::string const gradient : {"sph", "fpm"}) {
        auto c = channel(
            {.gradient = gradient, .velocity = "0, 0", .lid = "0, 0", .viscosity = 0, .viscous_force = "stress"});
        c.initial.pressure = "2";
        auto const scheme = make_scheme<2>(c);
        scheme->begin_step(0);
        EXPECT_LT(largest_acceleration(*scheme), 1e-12 * 2 / 0.05) << gradient;
    }
}

TEST(Walls, HoldWhatSlipsAlongThemByPressureAlone) {
    auto const scheme = make_scheme<2>(channel({.velocity = "3, 0", .lid = "0, 0", .slip = "free"}));
    scheme->begin_step(0);
    EXPECT_LT(largest_acceleration(*scheme), 1e-12 * 3 * 2 * 0.5 / (0.05 * 0.05));
    auto const stuck = make_scheme<2>(channel({.velocity = "3, 0", .lid = "0, 0", .slip = "none"}));
    stuck->begin_step(0);
    EXPECT_GT(largest_acceleration(*stuck), 10);
}

TEST(Walls, ContinueTheColumnOfLiquid) {
    auto c = channel({.velocity = "0, 0", .lid = "0, 0"});
    c.fluid.gravity = {0.3, -2};
    c.fluid.body_force = {"0", "1.5"};
    c.initial.pressure = "3 - 0.5*y";  // at rest across the channel
    auto const scheme = make_scheme<2>(c);
    scheme->begin_step(0);
    auto const& particles = scheme->particles();
    auto const view = particles.view();
    for (std::size_t w = particles.begin(Role::wall); w < particles.end(Role::wall); ++w) {
        auto const to_mirror = view.get<ToMirror>(w), x = view.get<Position>(w);
        // Along the wall nothing varies; each wall particle has the pressure at its own height.
        EXPECT_NEAR(view.get<Pressure>(w), 3 - 0.5 * x[1], 1e-12);
        EXPECT_NEAR(to_mirror[0], 0, 1e-12);
        EXPECT_LT(std::fabs(x[1] + to_mirror[1]), 0.5);
    }
}

TEST(Walls, ReflectSoundInSymplecticSteps) {
    // The lowest standing wave between the plates, A cos(pi y), of period 2/c = 0.2 s: after five periods it is back.
    // Smoothed gradients make sound slower, by 1 - 0.996 of the kernel's slope moment and by about (k H)^2/20 = 0.013,
    // together less than 2 %: after 10 pi the phase is off by less than 0.6, whose cos^2 is above 0.65.
    for (std::string const gradient : {"sph", "fpm"}) {
        auto c = channel({.gradient = gradient, .velocity = "0, '0.01*cos(pi*y)'", .lid = "0, 0", .viscosity = 0});
        c.time.stepping = "symplectic-euler";
        auto const scheme = make_scheme<2>(c);
        double const before = totals(scheme->particles()).kinetic_energy, step = 1e-3;
        double largest = 0;
        for (int n = 0; n < 1000; ++n) {
            scheme->begin_step(n * step);
            scheme->advance(n * step, step);
            if (n >= 800) largest = std::max(largest, totals(scheme->particles()).kinetic_energy);
        }
        EXPECT_NEAR(largest, before, 0.02 * before) << gradient << ": neither amplified nor damped";
        EXPECT_GT(totals(scheme->particles()).kinetic_energy, 0.65 * before) << gradient << ": in phase";
    }
}

TEST(Walls, StopWhatRunsIntoThem) {
    // A stream towards the upper wall is thrown back: nothing passes.
    auto c = channel({.velocity = "0, 0.5", .lid = "0, 0"});
    auto const scheme = make_scheme<2>(c);
    double time = 0;
    while (time < 0.3) {
        scheme->begin_step(time);
        double const step = scheme->time_limit().step;
        scheme->advance(time, step);
        time += step;
    }
    auto const y = scheme->particles().get<Position>(1);
    for (std::size_t i = 0; i < scheme->particles().owned(); ++i) EXPECT_LT(std::fabs(y[i]), 0.5);
}

TEST(PeriodicBox, IsTheSameWhereverItIsCut) {
    ChannelOptions const options{.gradient = "fpm",
                                 .velocity = "'sin(2*pi*x/0.6)', 'cos(2*pi*y) + sin(2*pi*x/0.6)'",
                                 .periodic = "xy",
                                 .jitter = 0.2,
                                 .viscous_force = "stress"};
    auto c = channel(options);
    c.initial.pressure = "sin(2*pi*y)";
    auto const here = make_scheme<2>(c);
    WeaklyCompressible<2>::Settings s;
    s.kernel = make_kernel("wendland-c2", 2, 0.16);
    s.liquid.rheology.viscosity = 0.5;
    s.equation_of_state = {EquationOfState::Kind::linear, 1, 10, 7};
    auto const rates = [&](Vector<double, 2> const& centre) {
        s.box.periodic[0] = s.box.periodic[1] = true;
        s.box.size = {{0.6, 1}};
        s.box.low = centre - 0.5 * s.box.size;
        Particles<2> particles(here->particles().owned());
        particles.allocate(Fields<Position, Velocity, Density, Mass>{});
        auto const from = here->particles().view(), to = particles.view();
        for (std::size_t i = 0; i < particles.owned(); ++i) {
            to.set<Position>(i, from.get<Position>(i));
            to.set<Velocity>(i, from.get<Velocity>(i));
            to.set<Density>(i, from.get<Density>(i));
            to.set<Mass>(i, from.get<Mass>(i));
        }
        WeaklyCompressible<2> scheme(s, std::move(particles));
        scheme.evaluate(0);
        std::vector<Vector<double, 2>> dv(scheme.particles().owned());
        for (std::size_t i = 0; i < dv.size(); ++i)
            dv[static_cast<std::size_t>(scheme.particles().id[i])] = scheme.particles().view().get<Acceleration>(i);
        return dv;
    };
    auto const a = rates({{0, 0}}), b = rates({{0.123, -0.377}});
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int k = 0; k < 2; ++k) EXPECT_NEAR(a[i][k], b[i][k], 1e-9 * (1 + std::fabs(a[i][k])));
}

TEST(PeriodicBox, KeepsMomentum) {
    for (std::string const gradient : {"sph", "fpm"}) {
        auto const scheme = make_scheme<2>(channel({.gradient = gradient,
                                                    .velocity = "'sin(2*pi*x/0.6)', 'cos(2*pi*y)'",
                                                    .periodic = "xy",
                                                    .jitter = 0.2,
                                                    .viscous_force = "stress"}));
        scheme->begin_step(0);
        auto const view = scheme->particles().view();
        for (int k = 0; k < 2; ++k) {
            auto const [sum, size] = sum_and_size(scheme->particles().owned(), [&](std::size_t i) {
                return view.get<Mass>(i) * view.get<Acceleration>(i)[k];
            });
            EXPECT_LT(std::fabs(sum), 1e-13 * size) << gradient;
        }
    }
}

TEST(ShiftingAtWalls, TakesALinearFlowAlong) {
    // Wall particles continue the flow between the plates, and images repeat it: wherever a particle is moved it has
    // the velocity of that place. The step is so short that the flow has no time to change: velocities differ by what
    // the shift alone has done to them.
    double const step = 1e-7;
    for (std::string const shifting : {"xu", "jahanbakhsh", "sun"}) {
        auto const state = [&](std::string const& which) {
            auto const scheme = make_scheme<2>(channel({.jitter = 0.3, .shifting = which}));
            scheme->begin_step(0);
            scheme->advance(0, step);
            auto const& particles = scheme->particles();
            std::vector<double> now(4 * particles.owned());
            for (std::size_t i = 0; i < particles.owned(); ++i)
                for (int k = 0; k < 2; ++k) {
                    now[4 * static_cast<std::size_t>(particles.id[i]) + k] = particles.get<Position>(k)[i];
                    now[4 * static_cast<std::size_t>(particles.id[i]) + 2 + k] = particles.get<Velocity>(k)[i];
                }
            return now;
        };
        auto const stays = state("none"), shifted = state(shifting);
        double largest = 0, worst = 0;
        for (std::size_t row = 0; row < stays.size(); row += 4) {
            double const dx = shifted[row] - stays[row], dy = shifted[row + 1] - stays[row + 1];
            largest = std::max(largest, std::hypot(dx, dy));
            worst = std::max({worst, std::fabs(shifted[row + 2] - stays[row + 2] - dy),
                              std::fabs(shifted[row + 3] - stays[row + 3])});
        }
        EXPECT_GT(largest, 0.1 * 0.5 * step) << shifting;
        // The accelerations of jittered particles, up to 2 nu v/dx^2, have changed the slope of the flow in the step.
        EXPECT_LT(worst, 10 * largest * step * 2 * 0.5 / (0.05 * 0.05)) << shifting;
    }
}

TEST(ShiftingAtWalls, PushesNothingIntoThem) {
    for (std::string const shifting : {"xu", "jahanbakhsh", "sun"}) {
        auto c =
            channel({.velocity = "0, '0.5*y*cos(2*pi*x/0.6)'", .lid = "0, 0", .jitter = 0.45, .shifting = shifting});
        c.method.shifting_coefficient = shifting == "sun" ? 10 : 1;
        auto const stays = [&] {
            auto calm = c;
            calm.method.shifting = "none";
            return after_steps(calm, 1);
        }();
        auto const shifted = after_steps(c, 1);
        double moved = 0;
        for (std::size_t row = 0; row < stays.size(); row += 5) {
            double const before = std::fabs(stays[row + 1]), after = std::fabs(shifted[row + 1]);
            if (before > 0.5 - 0.025) EXPECT_LE(after, before + 1e-15) << shifting;
            else EXPECT_LE(after, 0.5 - 0.025 + 1e-15) << shifting;
            moved = std::max(moved, std::fabs(after - before));
        }
        EXPECT_GT(moved, 1e-5) << shifting;
    }
}

TEST(ShiftingAtWalls, DoesTheSameIn3D) {
    // v = (y, 0, 0) between plates at y = -0.4 and 0.4 m, periodic along x and z; a step that leaves no time to change.
    double const step = 1e-7, dx = 0.1;
    for (std::string const shifting : {"xu", "jahanbakhsh", "sun"}) {
        auto const state = [&](std::string const& which) {
            auto const scheme = make_scheme<3>(read_case(
                fmt::format(
                    "name = 'plates'\ndimension = 3\n[domain]\nperiodic = 'xz'\nsize = [0.6, 0.8, 0.6]\n"
                    "[particles]\nspacing = {}\norigin = 'cell'\njitter = 0.4\n"
                    "[initial]\nvelocity = ['y', 0, 0]\n[fluid]\ndensity = 1\nviscosity = 0.5\nsound_speed = 10\n"
                    "[method]\ngradient = 'fpm'\nviscous_force = 'morris'\nkernel = 'wendland-c2'\nsupport = 2.6\n"
                    "shifting = '{}'\n[time]\nend = 0.1\n[[shapes]]\nkind = 'box'\nsize = [0.6, 0.8, 0.6]\n"
                    "[[walls]]\nkind = 'box'\nsize = [9, 0.8, 9]\nsurface_velocity = ['y', 0, 0]\n",
                    dx, which),
                "plates"));
            scheme->begin_step(0);
            scheme->advance(0, step);
            auto const& particles = scheme->particles();
            std::vector<std::pair<Vector<double, 3>, Vector<double, 3>>> now(particles.owned());
            for (std::size_t i = 0; i < now.size(); ++i)
                now[static_cast<std::size_t>(particles.id[i])] = {particles.view().get<Position>(i),
                                                                  particles.view().get<Velocity>(i)};
            return now;
        };
        auto const stays = state("none"), shifted = state(shifting);
        double largest = 0, worst = 0;
        for (std::size_t i = 0; i < stays.size(); ++i) {
            auto const d = shifted[i].first - stays[i].first;
            largest = std::max(largest, std::sqrt(norm2(d)));
            auto dv = shifted[i].second - stays[i].second;
            dv[0] -= d[1];
            worst = std::max(worst, std::sqrt(norm2(dv)));
            double const before = std::fabs(stays[i].first[1]), after = std::fabs(shifted[i].first[1]);
            EXPECT_LE(after, std::max(before, 0.4 - dx / 2) + 1e-15) << shifting;
        }
        EXPECT_GT(largest, 0.1 * 0.4 * step) << shifting;
        EXPECT_LT(worst, 10 * largest * step * 2 * 0.5 / (dx * dx)) << shifting;
    }
}

TEST(ShiftingAtWalls, SpreadsACrowdInAPeriodicBox) {
    auto const least_distance = [](std::vector<double> const& state) {
        double least2 = 1;
        for (std::size_t a = 0; a < state.size(); a += 5)
            for (std::size_t b = 0; b < a; b += 5) {
                double const dx = std::remainder(state[a] - state[b], 0.6),
                             dy = std::remainder(state[a + 1] - state[b + 1], 1.0);
                least2 = std::min(least2, dx * dx + dy * dy);
            }
        return std::sqrt(least2);
    };
    ChannelOptions options{.velocity = "'0.5*sin(2*pi*y)', 0", .periodic = "xy", .jitter = 0.4, .shifting = "sun"};
    EXPECT_GT(least_distance(after_steps(channel(options), 200)), 0.6 * 0.05);
    options.shifting = "none";
    EXPECT_LT(least_distance(after_steps(channel(options), 200)), 0.5 * 0.05);
}

TEST(Threads, ChangeNoBitBetweenWalls) {
    for (bool const implicit : {false, true}) {
        auto c = channel({.velocity = "'2*y', '0.3*sin(2*pi*x/0.6)'", .jitter = 0.2, .shifting = "sun"});
        if (implicit) c.method.viscous_step = "implicit";
        set_threads(1);
        auto const one = after_steps(c, 40);
        set_threads(3);
        auto const three = after_steps(c, 40);
        set_threads(0);
        EXPECT_EQ(one, three);
    }
}

TEST(ImplicitViscosity, GoesToTheSameSteadyFlowInLongSteps) {
    // Plane Poiseuille flow to 0.25 m/s, in steps of 25 times the explicit limit h^2/(8 nu).
    auto c = channel({.velocity = "0, 0", .lid = "0, 0"});
    c.fluid.body_force = {"1", "0"};
    c.method.viscous_step = "implicit";
    c.method.tolerance = 1e-8;
    double const h = 3.2 * 0.05 / 3, step = 25 * h * h / (8 * 0.5);
    auto const scheme = make_scheme<2>(c);
    double time = 0;
    for (int n = 0; n < 300; ++n, time += step) {
        scheme->begin_step(time);
        // Sound would limit the step; along the channel there is none.
        scheme->advance(time, step);
    }
    auto const view = scheme->particles().view();
    double const centre =
        max_over(scheme->particles().owned(), 0, [&](std::size_t i) { return view.get<Velocity>(i)[0]; });
    EXPECT_NEAR(centre, 0.25, 0.02 * 0.25);
}

TEST(ImplicitViscosity, KeepsMomentumInAPeriodicBox) {
    auto c = channel({.velocity = "'sin(2*pi*x/0.6)', 'cos(2*pi*y)'", .periodic = "xy", .jitter = 0.2});
    c.method.viscous_step = "implicit";
    c.method.tolerance = 1e-12;
    auto const scheme = make_scheme<2>(c);
    scheme->begin_step(0);
    auto const before = totals(scheme->particles());
    scheme->advance(0, 2e-3);
    auto const after = totals(scheme->particles());
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(after.momentum[k], before.momentum[k], 1e-11 * before.momentum_scale);
}

}  // namespace coronet
