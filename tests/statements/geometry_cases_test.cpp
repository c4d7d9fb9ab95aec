// SPDX-License-Identifier: BSD-3-Clause

// The built-in cases sphere-array and dam-break, coarse and short.

#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "coronet/cases/closed_surface.hpp"
#include "coronet/cases/sensor_probe.hpp"
#include "coronet/cases/sphere_array.hpp"
#include "tests/io/mesh_files.hpp"
#include "tests/statements/liquid.hpp"

namespace coronet {

namespace {

/// Runs a case to its end, sampled as it says, and returns the measures of its probes.
template <int D>
std::map<std::string, double> measured(Case const& c) {
    auto const scheme = make_scheme<D>(c);
    auto const probes = make_probes<D>(c);
    double time = 0, due = 0;
    while (true) {
        scheme->begin_step(time);
        if (time >= due || time >= c.time.end) {
            scheme->refresh();
            for (auto const& probe : probes) probe->sample(Snapshot<D>(time, scheme->particles(), c));
            due += c.output.series_every;
        }
        if (time >= c.time.end) break;
        double const step = std::min(scheme->time_limit().step, c.time.end - time);
        scheme->advance(time, step);
        time += step;
    }
    std::map<std::string, double> values;
    for (auto const& probe : probes)
        for (Measure const& m : probe->measures()) values[m.name] = m.value;
    return values;
}

}  // namespace

TEST(SphereArrayTheory, IsThatOfZickAndHomsy) {
    EXPECT_NEAR(sphere_array_drag(0.027), 2.008, 5e-4);
    EXPECT_NEAR(sphere_array_drag(0.064), 2.810, 5e-4);
    EXPECT_NEAR(sphere_array_drag(0.125), 4.292, 5e-4);
    EXPECT_NEAR(sphere_array_drag(0.216), 7.442, 2e-3);
    EXPECT_EQ(sphere_array_drag(0.343), 15.4);
    EXPECT_FALSE(std::isfinite(sphere_array_drag(0.3)));
}

TEST(SphereArray, HasAboutItsDragFromAShapeAndTheSameFromAFile) {
    auto c = load_case("sphere-array", {"particles.spacing=0.1", "output.series_every=0.2"});
    auto const shape = measured<3>(c);
    EXPECT_NEAR(shape.at("drag_error"), 0, 0.25);  // of a sphere 3.7 spacings in radius
    EXPECT_NEAR(shape.at("drag_balance"), 1, 0.01);

    Mesh mesh = sphere(1000, 4);  // in millimetres, as large as the ball in volume
    Triangles triangles;
    triangles.corners = mesh;
    triangles.place.assign(mesh.size(), 1);
    double const of_unit = ClosedSurface(triangles, 1e-3, "sphere").volume();
    c.walls[0].kind = "mesh";
    c.walls[0].unit = 1e-3 * 0.37221 * std::cbrt(4.1887902 / of_unit);
    c.walls[0].surface = std::make_shared<ClosedSurface>(triangles, c.walls[0].unit, "sphere");
    EXPECT_NEAR(measured<3>(c).at("drag_coefficient"), shape.at("drag_coefficient"),
                0.01 * shape.at("drag_coefficient"));
}

TEST(DamBreak, HasAFrontThatRunsAsMeasured) {
    auto const wide = measured<2>(load_case("dam-break", {"particles.spacing=0.02", "time.end=0.31"}));
    EXPECT_LT(std::fabs(wide.at("front_error_lobovsky_300")), 0.09);
    EXPECT_EQ(wide.at("front_error"), std::fabs(wide.at("front_error_lobovsky_300")));
    // Where the zero of time is not known: as measured, but for one number.
    auto const tall = measured<2>(
        load_case("dam-break", {"particles.spacing=0.015", "parameters.width=0.15", "shapes.0.size=[0.15, 0.3]",
                                "shapes.0.centre=[0.075, 0.15]", "time.end=0.32"}));
    EXPECT_LT(std::fabs(tall.at("front_error_martin_moyce_225")), 0.12);
    EXPECT_LT(std::fabs(tall.at("front_error_late_martin_moyce_1125")), 0.05);
    EXPECT_EQ(tall.count("pressure_error"), 0u);
}

TEST(DamBreak, BehindItsGateIsNearerToTheExperiment) {
    auto const let_go = measured<2>(load_case("dam-break", {"particles.spacing=0.02", "time.end=0.31"}));
    auto const gate = measured<2>(load_case("dam-break-gate", {"particles.spacing=0.02", "walls.1.size=[0.06, 0.35]",
                                                               "walls.1.centre=[0.63, 0.175]", "time.end=0.31"}));
    EXPECT_LT(std::fabs(gate.at("front_error_lobovsky_300")), std::fabs(let_go.at("front_error_lobovsky_300")));
    EXPECT_EQ(gate.at("through_walls"), 0);  // the gate has gone, and leaves no wall where it was
}

TEST(DamBreak, HasAFrontAlongTheFloor) {
    auto c = load_case("dam-break", {});
    Shape spray = c.shapes[0];
    spray.centre = {1.2, 0.8};
    spray.size = {0.05, 0.05};
    c.shapes.push_back(spray);
    auto const scheme = make_scheme<2>(c);
    EXPECT_NEAR(make_probes<2>(c)[0]->sample(Snapshot<2>(0, scheme->particles(), c))[0], 0.6, 1e-12);
}

TEST(DamBreak, StartsAsPotentialFlowSays) {
    // Let go, a column of depth H and width W has the pressure rho g (H - y - sum A cos(k y) cosh(k x)/cosh(k W)), k =
    // (n + 1/2) pi/H, A = 2/(H k^2): none at the top and the front, no force through floor and wall.
    double const H = 0.3, W = 0.15, g = 9.81;
    auto const wave = [&](int n) { return (n + 0.5) * std::numbers::pi / H; };
    std::string pressure = "1000*9.81*max(0, 0.3 - y";
    for (int n = 0; n < 12; ++n)
        pressure += fmt::format(" - {0:.12g}*cos({1:.12g}*y)*(exp({1:.12g}*(x - 0.15)) + exp(-{1:.12g}*(x + 0.15)))",
                                2 / (H * std::pow(wave(n), 2)) / (1 + std::exp(-2 * wave(n) * W)), wave(n));
    auto const c = load_case("dam-break", {"parameters.width=0.15", "shapes.0.size=[0.15, 0.3]",
                                           "shapes.0.centre=[0.075, 0.15]", "initial.pressure='" + pressure + ")'"});
    auto const scheme = make_scheme<2>(c);
    auto const& particles = scheme->particles();
    std::map<std::int64_t, Vector<double, 2>> start;  // of the front between its ends
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        auto const x = particles.view().get<Position>(i);
        if (x[0] > W - c.particles.spacing && x[1] > 0.05 && x[1] < 0.25) start[particles.id[i]] = x;
    }
    double const end = 0.01;  // short beside sqrt(H/g)
    for (double time = 0; time < end;) {
        scheme->begin_step(time);
        double const step = std::min(scheme->time_limit().step, end - time);
        scheme->advance(time, step);
        time += step;
    }
    ASSERT_EQ(start.size(), 20u);
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        if (start.count(particles.id[i]) == 0) continue;
        auto const x = start[particles.id[i]];
        double acceleration = 0;
        for (int n = 0; n < 1000; ++n) {
            double const k = wave(n);
            acceleration += g * 2 / (H * k) * std::cos(k * x[1]) *
                            (std::exp(k * (x[0] - W)) - std::exp(-k * (x[0] + W))) / (1 + std::exp(-2 * k * W));
        }
        double const gone = particles.view().get<Position>(i)[0] - x[0];
        EXPECT_NEAR(gone / (acceleration * end * end / 2), 1, 0.06) << "from y = " << x[1];
    }
}

TEST(Impact, IsComparedWithTheSensorOfItsPlaceAndWidth) {
    auto const names = [](std::vector<std::string> const& changes) {
        auto const c = load_case("dam-break", changes);
        std::set<std::string> all;
        for (auto const& probe : make_probes<2>(c))
            for (Measure const& m : probe->measures()) all.insert(m.name);
        return all;
    };
    auto const all = names({});
    for (char const* name : {"arrival_error", "pressure_error", "pressure_error_inviscid", "pressure_error_p3",
                             "pressure_error_p4_inviscid", "pressure_error_buchner"})
        EXPECT_EQ(all.count(name), 1u) << name;
    EXPECT_EQ(names({"probes.1.at=[1.61, 0.02]"}).count("pressure_error"), 0u);
    EXPECT_EQ(names({"probes.4.sensor_width=0.03"}).count("pressure_error_buchner"), 0u);
    EXPECT_EQ(names({"parameters.width=0.5"}).count("pressure_error"), 0u);
}

TEST(Sensor, ReadsThePressureAtTheWall) {
    auto const c = load_case("dam-break", {"shapes.0.size=[1.61, 0.3]", "shapes.0.centre=[0.805, 0.15]",
                                           "initial.pressure='1000*9.81*(0.3 - y)'"});
    auto const scheme = make_scheme<2>(c);
    scheme->begin_step(0);
    scheme->refresh();
    for (double const width : {0.0, 0.05})
        EXPECT_NEAR(Sensor<2>({{1.61, 0.1}}, width, c).pressure(scheme->particles()), 1000 * 9.81 * 0.2, 1e-3 * 1962);
    // In the floor only what stands above is seen, a spacing or so away.
    EXPECT_NEAR(Sensor<2>({{0.8, 0}}, 0.0, c).pressure(scheme->particles()), 1000 * 9.81 * 0.3, 1000 * 9.81 * 0.012);
}

}  // namespace coronet
