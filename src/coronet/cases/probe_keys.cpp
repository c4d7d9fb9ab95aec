// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/probe_keys.hpp"

namespace coronet {

void describe_probe(Keys& keys, ProbeKeys& probe, std::string const& path, int dimension) {
    auto const wants = [&](std::string const& kind) { return keys.everything() || probe.kind == kind; };
    std::vector<std::string> const ones(static_cast<std::size_t>(dimension), "1");
    Keys::Words kinds{"value", "angular-momentum", "stretching"};
    if (dimension == 2) kinds.insert(kinds.end(), {"patch", "taylor-green"});
    kinds.insert(kinds.end(),
                 {"drop", "mode", "static-drop", "pieces", "channel", "cavity", "hydrostatic", "wall-force", "sensor"});
    if (dimension == 2) kinds.insert(kinds.end(), {"dam-break", "impact"});
    if (dimension == 3 || keys.everything()) kinds.insert(kinds.end(), {"drag", "column"});
    keys.choice({.path = path + ".kind", .meaning = "what is measured", .required = true}, probe.kind, kinds);
    if (wants("value") || wants("sensor") || wants("impact"))
        keys.text({.path = path + ".name", .meaning = "column of the series", .required = true}, probe.name);
    if (wants("value"))
        keys.choice({.path = path + ".field", .meaning = "of value: the field that is taken"}, probe.field,
                    {"pressure", "density", "speed"});
    if (wants("value") || wants("sensor") || wants("impact")) {
        if (probe.at.empty()) probe.at.assign(static_cast<std::size_t>(dimension), 0.0);
        keys.numbers({.path = path + ".at",
                      .unit = "m",
                      .meaning = "where, of a sensor on the surface of a wall; 0 is read where there is no liquid"},
                     probe.at, dimension);
    }
    if (wants("sensor") || wants("impact"))
        keys.number({.path = path + ".sensor_width",
                     .unit = "m",
                     .meaning = "of the face of a pressure sensor, along the wall: a line, in 3D a square",
                     .at_least = 0},
                    probe.sensor_width);
    if (wants("wall-force") || wants("drag"))
        keys.text({.path = path + ".wall",
                   .meaning = "of wall-force and drag: name of the wall whose force is taken",
                   .required = true},
                  probe.wall);
    if (wants("drag"))
        keys.formula(
            {.path = path + ".radius", .unit = "m", .meaning = "of drag: radius of the sphere in a periodic cube"},
            probe.radius);
    if (wants("stretching")) {
        keys.formulas(
            {.path = path + ".rates",
             .unit = "1/s",
             .meaning = "of stretching: the initial velocity is rates_k x_k; with the exact drop of that flow",
             .required = true},
            probe.rates, dimension);
        if (probe.semi_axes.empty()) probe.semi_axes = ones;
        keys.formulas({.path = path + ".semi_axes", .unit = "m", .meaning = "of stretching: those of the initial drop"},
                      probe.semi_axes, dimension);
    }
    if (wants("patch") || wants("cavity") || wants("taylor-green"))
        keys.formula(
            {.path = path + ".side",
             .unit = "m",
             .meaning =
                 "of patch, cavity and taylor-green: of the initial square, of the cavity, or of the periodic square"},
            probe.side);
    if (wants("taylor-green"))
        keys.formula({.path = path + ".speed",
                      .unit = "m/s",
                      .meaning = "of taylor-green: largest speed of the initial vortices"},
                     probe.speed);
    if (wants("patch")) {
        keys.formula({.path = path + ".angular_velocity",
                      .unit = "1/s",
                      .meaning = "of patch: that of the initial rotation, clockwise"},
                     probe.angular_velocity);
    }
    if (wants("cavity") || wants("channel"))
        keys.formula({.path = path + ".upper_velocity",
                      .unit = "m/s",
                      .meaning = "of channel and cavity: of the upper plate or the lid, along x"},
                     probe.upper_velocity);
    if (wants("channel")) {
        keys.choice(
            {.path = path + ".flow", .meaning = "of channel: what the exact flow is, steady or from rest at t = 0"},
            probe.flow, {"steady", "from-rest"});
        keys.formula(
            {.path = path + ".gap",
             .unit = "m",
             .meaning = "of channel: between plates at y = -gap/2 and gap/2; gravity and body force drive along x"},
            probe.gap);
        keys.formula(
            {.path = path + ".lower_velocity", .unit = "m/s", .meaning = "of channel: of the lower plate, along x"},
            probe.lower_velocity);
    }
    if (wants("hydrostatic") || wants("dam-break") || wants("impact"))
        keys.formula(
            {.path = path + ".depth",
             .unit = "m",
             .meaning =
                 "of hydrostatic: of the liquid at rest, along gravity; of dam-break and impact: height of the column"},
            probe.depth);
    if (wants("dam-break") || wants("impact"))
        keys.formula({.path = path + ".width", .unit = "m", .meaning = "of dam-break and impact: of the column"},
                     probe.width);
    if (wants("mode"))
        keys.integer({.path = path + ".mode",
                      .unit = "-",
                      .meaning = "of mode: n of the amplitude of cos(n theta) on a drop",
                      .at_least = 2,
                      .at_most = 100},
                     probe.mode);
    if (wants("column"))
        keys.integer({.path = path + ".waves",
                      .unit = "-",
                      .meaning = "of column: of the amplitude that is shown, on a column as long as the periodic box",
                      .at_least = 1,
                      .at_most = 100},
                     probe.waves);
}

}  // namespace coronet
