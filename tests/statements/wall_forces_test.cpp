// SPDX-License-Identifier: BSD-3-Clause

// What liquid does to walls, and walls that move to liquid.

#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "coronet/cases/probe.hpp"
#include "coronet/cases/wall_force_probe.hpp"
#include "coronet/core/parallel.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

struct TankOptions {
    std::string gradient = "sph", velocity = "'0.3*sin(5*y)', '0.2*cos(4*x)'", pressure = "1 + x - 2*y";
    std::string liquid = "viscosity = 0.3", viscous_force = "morris", slip = "none", periodic = "none", motion = "";
    double jitter = 0.2, gravity = 0;
    std::string more = "";  ///< of the method
    std::string stepping = "predictor-corrector";
};

/// A square of liquid of density 1 in a closed tank of 1 m, with a disc that stands in it; two walls.
Case tank(TankOptions const& o) {
    return read_case(
        fmt::format(
            "name = 'tank'\ndimension = 2\n"
            "{}"
            "[particles]\nspacing = 0.05\norigin = 'cell'\njitter = {}\n"
            "[initial]\nvelocity = [{}]\npressure = '{}'\n"
            "[fluid]\ndensity = 1\n{}\nsound_speed = 20\ngravity = [0, {}]\n"
            "[method]\ngradient = '{}'\nviscous_force = '{}'\nkernel = 'wendland-c2'\nsupport = 3.2\n{}\n"
            "[time]\nend = 1\nstepping = '{}'\n"
            "[[shapes]]\nkind = 'box'\ncentre = [0.5, 0.5]\nsize = [1, 1]\n"
            "[[walls]]\nname = 'tank'\nkind = 'box'\ncentre = [0.5, 0.5]\nsize = [{}, 1]\nslip = '{}'\n{}\n"
            "[[walls]]\nname = 'pin'\nkind = 'disc'\nsolid = 'inside'\ncentre = [0.45, 0.55]\nradius = 0.17\n{}\n",
            o.periodic == "x" ? "[domain]\nperiodic = 'x'\ncentre = [0.5, 0.5]\nsize = [1, 1]\n" : "", o.jitter,
            o.velocity, o.pressure, o.liquid, o.gravity, o.gradient, o.viscous_force, o.more, o.stepping,
            o.periodic == "x" ? 9 : 1, o.slip, o.motion, o.motion),
        "tank");
}

template <int D>
std::unique_ptr<Scheme<D>> evaluated(Case const& c, double time = 0) {
    auto scheme = make_scheme<D>(c);
    scheme->begin_step(time);
    scheme->refresh();
    return scheme;
}

/// Of a tank with its liquid moved and turned as a rigid body.
double largest_difference(Scheme<2> const& scheme, auto const& expected) {
    auto const view = scheme.particles().view();
    return std::sqrt(max_over(scheme.particles().owned(), 0, [&](std::size_t i) {
        return norm2(view.template get<Acceleration>(i) - expected(view.template get<Position>(i)));
    }));
}

}  // namespace

TEST(WallForces, AreWhatTheLiquidLosesToRoundOff) {
    std::string const thinning =
        "rheology = 'power-law'\nconsistency = 0.3\npower_index = 0.6\nshear_rate_min = 0.1\nshear_rate_max = 100";
    TankOptions const cases[] = {
        {},
        {.periodic = "x"},
        {.slip = "free", .gravity = -3},
        {.more = "artificial_viscosity = 0.2"},
        {.liquid = thinning},
        {.gradient = "fpm", .liquid = "viscosity = 0", .viscous_force = "stress", .periodic = "x"},
        {.gradient = "fpm", .periodic = "x"}};
    for (auto const& options : cases) {
        auto const scheme = evaluated<2>(tank(options));
        auto const& particles = scheme->particles();
        auto const view = particles.view();
        auto const on_tank = wall_load<2>(particles, 0, {}), on_pin = wall_load<2>(particles, 1, {});
        for (int k = 0; k < 2; ++k) {
            auto const [sum, size] = sum_and_size(particles.owned(), [&](std::size_t i) {
                return view.get<Mass>(i) * (view.get<Acceleration>(i)[k] - (k == 1 ? options.gravity : 0));
            });
            EXPECT_NEAR(sum + on_tank.force[k] + on_pin.force[k], 0, 1e-13 * size);
            EXPECT_GT(std::fabs(on_pin.force[k]), 1e-4 * size);
        }
    }
}

TEST(WallForces, AreThoseOfNowWithSymplecticStepsToo) {
    for (auto options : {TankOptions{}, TankOptions{.gradient = "fpm", .periodic = "x"}}) {
        auto const scheme = evaluated<2>(tank(options));
        options.stepping = "symplectic-euler";
        auto const other = evaluated<2>(tank(options));
        for (int wall : {0, 1}) {
            auto const load = wall_load<2>(scheme->particles(), wall, {}),
                       same = wall_load<2>(other->particles(), wall, {});
            for (int k = 0; k < 2; ++k) EXPECT_NEAR(load.force[k], same.force[k], 1e-12);
        }
    }
}

TEST(WallForces, OfPressureAloneTurnWallsAsMuchAsTheLiquid) {
    // Pressure acts along the line of a pair, so that its torque is equal and opposite, too.
    auto const scheme = evaluated<2>(tank({.liquid = "viscosity = 0", .viscous_force = "stress"}));
    auto const& particles = scheme->particles();
    auto const view = particles.view();
    Vector<double, 2> const about{{0.2, -0.4}};
    auto const [sum, size] = sum_and_size(particles.owned(), [&](std::size_t i) {
        auto const r = view.get<Position>(i) - about, a = view.get<Acceleration>(i);
        return view.get<Mass>(i) * (r[0] * a[1] - r[1] * a[0]);
    });
    double const on_walls = wall_load(particles, 0, about).torque[2] + wall_load(particles, 1, about).torque[2];
    EXPECT_NEAR(sum + on_walls, 0, 1e-13 * size);
}

TEST(WallForces, InThreeDimensionsAreWhatTheLiquidLoses) {
    auto c = read_case(
        "name = 'array'\ndimension = 3\n[domain]\nperiodic = 'xyz'\nsize = [1, 1, 1]\n"
        "[particles]\nspacing = 0.125\norigin = 'cell'\njitter = 0.2\n[initial]\nvelocity = ['sin(6*y)', 'x*z', "
        "'cos(6*x)']\n"
        "pressure = '1 + 0.2*sin(6*x)'\n[fluid]\ndensity = 1\nviscosity = 0.3\nsound_speed = 20\n"
        "[method]\ngradient = 'sph'\nviscous_force = 'morris'\nkernel = 'wendland-c2'\nsupport = 2.6\n[time]\nend = 1\n"
        "[[shapes]]\nkind = 'box'\nsize = [1, 1, 1]\n"
        "[[walls]]\nname = 'egg'\nkind = 'ellipse'\nsolid = 'inside'\nsemi_axes = [0.4, 0.3, 0.25]\nrotation = 20\n",
        "array");
    auto const scheme = evaluated<3>(c);
    auto const view = scheme->particles().view();
    auto const load = wall_load<3>(scheme->particles(), 0, {});
    for (int k = 0; k < 3; ++k) {
        auto const [sum, size] = sum_and_size(scheme->particles().owned(), [&](std::size_t i) {
            return view.get<Mass>(i) * view.get<Acceleration>(i)[k];
        });
        EXPECT_NEAR(sum + load.force[k], 0, 1e-13 * size);
        EXPECT_GT(std::fabs(load.force[k]), 1e-4 * size);
    }
}

TEST(WallForces, BearTheWeightOfLiquidAtRest) {
    auto c = tank({.velocity = "0, 0",
                   .pressure = "10*(1 - y)",
                   .liquid = "viscosity = 0",
                   .viscous_force = "stress",
                   .jitter = 0,
                   .gravity = -10});
    c.particles.spacing = 0.02;
    auto const scheme = evaluated<2>(c);
    double const mass = totals(scheme->particles()).mass, pi = 3.14159265358979, weight = 10 * pi * 0.17 * 0.17;
    auto const on_tank = wall_load<2>(scheme->particles(), 0, {}).force,
               on_pin = wall_load<2>(scheme->particles(), 1, {}).force;
    EXPECT_NEAR(on_tank[1] + on_pin[1], -10 * mass, 0.02 * 10 * mass);
    EXPECT_NEAR(on_pin[1], weight, 0.08 * weight);  // Archimedes, of a pin of 8.5 spacings
}

TEST(MovingWalls, TakeTheirLiquidAlong) {
    // Pushed with a constant acceleration, with the pressure that this takes: nothing moves relative to the tank.
    TankOptions options{
        .velocity = "0, 0", .pressure = "2 - 3*x", .motion = "displacement = ['1.5*t^2', 0]", .jitter = 0};
    auto const with_tank = [&] {
        auto c = tank(options);
        c.walls.pop_back();
        return evaluated<2>(c);
    };
    Vector<double, 2> const a{{3, 0}};
    auto const all = [&](auto const&) { return a; };
    EXPECT_LT(largest_difference(*with_tank(), all), 0.01 * 3);  // but for plain gradients on a lattice
    options.motion = "";
    EXPECT_GT(largest_difference(*with_tank(), all), 0.3 * 3);
}

TEST(MovingWalls, FeelWhatLiquidInMotionWithThemExertsAtRest) {
    // The same forces whether all rests or moves steadily, and after the wall has gone some way.
    TankOptions options{.pressure = "1 + x - 2*y"};
    auto const rest = evaluated<2>(tank(options));
    options.velocity = "'0.3*sin(5*y) + 2', '0.2*cos(4*x) - 1'";
    options.motion = "displacement = ['2*t', '-t']";
    auto const moving = evaluated<2>(tank(options));
    for (std::size_t wall : {0u, 1u}) {
        auto const a = wall_load<2>(rest->particles(), wall, {}), b = wall_load<2>(moving->particles(), wall, {});
        for (int k = 0; k < 2; ++k) EXPECT_NEAR(a.force[k], b.force[k], 1e-9 * (1 + std::fabs(a.force[k])));
        EXPECT_NEAR(a.torque[2], b.torque[2], 1e-9 * (1 + std::fabs(a.torque[2])));
    }
}

TEST(MovingWalls, TurnLiquidAsARigidBody) {
    // Turned steadily about the middle, with the pressure that holds the circles: acceleration is -omega^2 r, and
    // viscosity does nothing.
    double const omega = 3;
    TankOptions options{
        .velocity = "'-3*(y - 0.5)', '3*(x - 0.5)'", .pressure = "4.5*((x - 0.5)^2 + (y - 0.5)^2)", .jitter = 0};
    auto c = tank(options);
    c.walls.pop_back();
    c.walls[0].turn = "3*t*180/pi";
    auto const turned_tank = evaluated<2>(c);
    auto const expected = [&](Vector<double, 2> const& x) {
        return -omega * omega * (x - Vector<double, 2>{{0.5, 0.5}});
    };
    EXPECT_LT(largest_difference(*turned_tank, expected), 0.1 * omega * omega * 0.7);
    // The viscous force between velocities is that of mu grad v alone, which turns a wall where liquid has vorticity:
    // by 2 mu omega times the area inside.
    EXPECT_NEAR(wall_load<2>(turned_tank->particles(), 0, {{0.5, 0.5}}).torque[2], -2 * 0.3 * omega, 0.2 * 0.3 * omega);
    // It stays so for a while: a quarter of a turn and more, the walls wherever they are.
    double time = 0;
    while (time < 0.6) {
        turned_tank->begin_step(time);
        double const step = turned_tank->time_limit().step;
        turned_tank->advance(time, step);
        time += step;
    }
    turned_tank->begin_step(time);
    auto const view = turned_tank->particles().view();
    double slip = 0;
    for (std::size_t i = 0; i < turned_tank->particles().owned(); ++i) {
        auto const x = view.get<Position>(i) - Vector<double, 2>{{0.5, 0.5}};
        slip = std::max(slip, std::sqrt(norm2(view.get<Velocity>(i) - omega * Vector<double, 2>{{-x[1], x[0]}})));
    }
    EXPECT_LT(slip, 0.1 * omega * 0.7);
}

TEST(MovingWalls, PushLiquidAndAreFeltThroughAPeriodicFace) {
    // A pin that moves through a periodic box, across its face, drags liquid with it; the walls' momentum is the
    // liquid's.
    auto c = tank({.velocity = "0, 0", .pressure = "1", .periodic = "x", .jitter = 0});
    c.walls[0].displacement = {"0", "0"};
    c.walls[1].displacement = {"0.8*t", "0"};
    auto const scheme = make_scheme<2>(c);
    double time = 0;
    while (time < 0.8) {
        scheme->begin_step(time);
        double const step = scheme->time_limit().step;
        scheme->advance(time, step);
        time += step;
    }
    scheme->begin_step(time);
    scheme->refresh();
    EXPECT_GT(totals(scheme->particles()).momentum[0], 0.02);
    EXPECT_LT(wall_load<2>(scheme->particles(), 1, {}).force[0], 0);  // it is held back,
    EXPECT_GT(wall_load<2>(scheme->particles(), 0, {}).force[0], 0);  // and the plates are dragged
    auto const view = scheme->particles().view();
    double const centre = 0.45 + 0.8 * time;
    for (std::size_t i = 0; i < scheme->particles().owned(); ++i) {
        auto from = view.get<Position>(i) - Vector<double, 2>{{centre, 0.55}};
        from[0] -= std::round(from[0]);
        EXPECT_GT(std::sqrt(norm2(from)), 0.17 - 0.05);  // nothing is run over, but in notches of the lattice
    }
}

TEST(MovingWalls, DragLiquidToAndFroAsStokesSays) {
    // Between two plates that swing along themselves with u_w = U cos(w t): u = Re U exp(i w t) cosh(k y)/cosh(k/2),
    // k^2 = i w/nu, on either side of the middle of a gap of 1.
    double const w = 2 * std::numbers::pi, nu = 0.3, U = 0.4;
    auto c = tank({.velocity = "'0.4*(abs(y - 0.5) + 0.5)', 0", .pressure = "0", .periodic = "x", .jitter = 0});
    c.walls.pop_back();
    c.walls[0].displacement = {"0.4/(2*pi)*sin(2*pi*t)", "0"};
    auto const scheme = make_scheme<2>(c);
    double time = 0;
    while (time < 2.2) {
        scheme->begin_step(time);
        double const step = std::min(scheme->time_limit().step, 2.2 - time + 1e-12);
        scheme->advance(time, step);
        time += step;
    }
    std::complex<double> const k = std::sqrt(std::complex<double>(0, w / nu));
    auto const view = scheme->particles().view();
    double sum2 = 0;
    for (std::size_t i = 0; i < scheme->particles().owned(); ++i) {
        double const y = view.get<Position>(i)[1] - 0.5;
        auto const exact =
            U * std::real(std::exp(std::complex<double>(0, w * time)) * std::cosh(k * y) / std::cosh(0.5 * k));
        sum2 += std::pow(view.get<Velocity>(i)[0] - exact, 2);
    }
    EXPECT_LT(std::sqrt(sum2 / static_cast<double>(scheme->particles().owned())), 0.015 * U);
}

TEST(WallForces, HaveTheLeverToTheNearestCopyOfAWallThatCrossesAFace) {
    // Two wall particles beside x = 0.95, of a wall that moves: one has left the box on the right and come back.
    Particles<2> particles(0, 2);
    particles.allocate(Fields<Position, WallForce, WallNumber>{});
    auto const view = particles.view();
    std::size_t const first = particles.begin(Role::wall);
    for (std::size_t k = 0; k < 2; ++k) {
        view.set<Position>(first + k, {{k == 0 ? 0.9 : 0.05, 0}});
        view.set<WallForce>(first + k, {{0, 2}});
        view.at<WallNumber>()[first + k] = 0;
    }
    PeriodicBox<2> box;
    box.size = {{1, 1}};
    box.periodic[0] = true;
    EXPECT_NEAR(wall_load<2>(particles, 0, {{0.95, 0}}, box).torque[2], 2 * (-0.05 + 0.1), 1e-14);
    EXPECT_NEAR(wall_load<2>(particles, 0, {{0.95, 0}}).torque[2], 2 * (-0.05 - 0.9), 1e-14);
}

TEST(Threads, ChangeNoBitBetweenMovingWalls) {
    auto c = tank({.motion = "displacement = ['0.05*sin(20*t)', 0]\nturn = '100*t'"});
    auto const force = [&](int count) {
        set_threads(count);
        auto const scheme = make_scheme<2>(c);
        for (int n = 0; n < 30; ++n) {
            scheme->begin_step(n * 4e-4);
            scheme->advance(n * 4e-4, 4e-4);
        }
        scheme->begin_step(30 * 4e-4);
        scheme->refresh();
        auto const load = wall_load<2>(scheme->particles(), 1, {});
        return std::vector<double>{load.force[0], load.force[1], load.torque[2]};
    };
    auto const one = force(1), three = force(3);
    set_threads(0);
    EXPECT_EQ(one, three);
}

}  // namespace coronet
