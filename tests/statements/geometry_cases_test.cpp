// SPDX-License-Identifier: BSD-3-Clause

// The built-in cases sphere-array and dam-break, coarse and short.

#include <map>

#include <gtest/gtest.h>

#include "coronet/cases/closed_surface.hpp"
#include "coronet/cases/dam_break_probe.hpp"
#include "coronet/cases/probe.hpp"
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

TEST(DamBreak, HasAFrontThatRunsAboutAsMeasured) {
    auto const c =
        load_case("dam-break", {"particles.spacing=0.015", "parameters.width=0.15", "shapes.0.size=[0.15, 0.3]",
                                "shapes.0.centre=[0.075, 0.15]", "time.end=0.31"});
    auto const values = measured<2>(c);
    EXPECT_LT(std::fabs(values.at("front_error_martin_moyce_225")), 0.12);
    EXPECT_EQ(values.count("pressure_error"), 0u);
}

TEST(Curve, HasTheMeanOfItsTrapezia) {
    Curve const curve{{0, 1, 3}, {0, 2, 0}};
    EXPECT_EQ(curve.at(0.5), 1);
    EXPECT_EQ(curve.at(2), 1);
    EXPECT_NEAR(curve.mean(0.5, 2), (0.5 * 1.5 + 1 * 1.5) / 1.5, 1e-15);
    EXPECT_TRUE(std::isnan(curve.mean(0.5, 4)));
    EXPECT_EQ(curve.first_above(1), 1);
    EXPECT_TRUE(std::isnan(curve.first_above(2)));
    EXPECT_EQ(builtin_curve("dambreak_martin_moyce1952_a225").time.size(), 15u);
    EXPECT_TRUE(builtin_curve("nothing").time.empty());
}

TEST(Sensor, ReadsThePressureAtTheWall) {
    auto const c = load_case("dam-break", {"shapes.0.size=[1.61, 0.3]", "shapes.0.centre=[0.805, 0.15]",
                                           "initial.pressure='1000*9.81*(0.3 - y)'", "probes.0.at=[1.61, 0.1]"});
    auto const scheme = make_scheme<2>(c);
    scheme->begin_step(0);
    scheme->refresh();
    for (double const width : {0.0, 0.05})
        EXPECT_NEAR(Sensor<2>({{1.61, 0.1}}, width, c).pressure(scheme->particles()), 1000 * 9.81 * 0.2, 1e-3 * 1962);
    // In the floor only what stands above is seen, a spacing or so away.
    EXPECT_NEAR(Sensor<2>({{0.8, 0}}, 0.0, c).pressure(scheme->particles()), 1000 * 9.81 * 0.3, 1000 * 9.81 * 0.012);
}

}  // namespace coronet
