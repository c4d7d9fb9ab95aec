// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/boundaries.hpp"

namespace coronet {

namespace {

void describe_wall(Keys& keys, Wall& wall, std::string const& path, int dimension) {
    auto const wants = [&](std::string const& kind) { return keys.everything() || wall.kind == kind; };
    Keys::Words kinds{"box", "ellipse", dimension == 2 ? "disc" : "ball"};
    if (keys.everything()) kinds.push_back("ball");
    if (dimension == 2) kinds.push_back("polygon");
    if (dimension == 3 || keys.everything()) kinds.push_back("mesh");
    std::vector<double> const origin(static_cast<std::size_t>(dimension), 0.0);
    std::vector<double> const unit(static_cast<std::size_t>(dimension), 1.0);
    std::vector<std::string> const none(static_cast<std::size_t>(dimension), "0");

    keys.text({.path = path + ".name", .meaning = "by which a probe calls it; nothing: none does"}, wall.name);
    keys.choice({.path = path + ".kind",
                 .meaning = "form of the surface; an ellipse in 3D is an ellipsoid, a mesh is read from a file",
                 .required = true},
                wall.kind, kinds);
    keys.choice({.path = path + ".solid", .meaning = "which side of the surface is solid"}, wall.solid,
                {"outside", "inside"});
    if (wall.centre.empty()) wall.centre = origin;
    keys.numbers({.path = path + ".centre", .unit = "m", .meaning = "its centre"}, wall.centre, dimension);
    if (wants("box")) {
        if (wall.size.empty()) wall.size = unit;
        keys.numbers({.path = path + ".size", .unit = "m", .meaning = "edges of a box", .above = 0}, wall.size,
                     dimension);
    }
    if (wants("disc") || wants("ball"))
        keys.number({.path = path + ".radius", .unit = "m", .meaning = "of a disc or ball", .above = 0}, wall.radius);
    if (wants("polygon"))
        keys.numbers({.path = path + ".corners",
                      .unit = "m",
                      .meaning = "of a polygon, from the centre: x, y of one after another",
                      .required = true},
                     wall.corners, Keys::any_even_size);
    if (wants("ellipse")) {
        if (wall.semi_axes.empty()) wall.semi_axes = unit;
        keys.numbers({.path = path + ".semi_axes", .unit = "m", .meaning = "of an ellipse", .above = 0}, wall.semi_axes,
                     dimension);
    }
    if (wants("mesh")) {
        keys.text({.path = path + ".file",
                   .meaning = "of a mesh: a closed surface of triangles, .stl (ASCII or binary) or .obj; its path from "
                              "the folder of the case",
                   .required = true},
                  wall.file);
        keys.number({.path = path + ".unit",
                     .unit = "m",
                     .meaning = "length of a unit of the file: 0.001 if it is in millimetres",
                     .above = 0},
                    wall.unit);
    }
    keys.number({.path = path + ".rotation", .unit = "degrees", .meaning = "turn about its centre, in the x-y plane"},
                wall.rotation);
    keys.choice({.path = path + ".slip", .meaning = "none: liquid sticks to it; free: liquid slides along it"},
                wall.slip, {"none", "free"});
    if (wall.surface_velocity.empty()) wall.surface_velocity = none;
    keys.formulas({.path = path + ".surface_velocity",
                   .unit = "m/s",
                   .meaning = "of a surface that slides along itself, as a lid or a turning cylinder does: the wall "
                              "stays where it is"},
                  wall.surface_velocity, dimension);
    if (wall.displacement.empty()) wall.displacement = none;
    keys.formulas({.path = path + ".displacement",
                   .unit = "m",
                   .meaning = "of the whole wall at time t, from where it is at t = 0"},
                  wall.displacement, dimension);
    keys.formula({.path = path + ".turn",
                  .unit = "degrees",
                  .meaning = "of the whole wall at time t, about its centre in the x-y plane"},
                 wall.turn);
}

}  // namespace

void describe_boundaries(Keys& keys, Case& c) {
    int const D = c.dimension;
    keys.tables(
        {.path = "walls", .meaning = "what bounds the liquid: the union of their solids"}, c.walls.size(),
        [&](std::size_t n) { c.walls.resize(n); },
        [&](std::size_t k, std::string const& path) { describe_wall(keys, c.walls[k], path, D); });
    Keys::Words axes{"none", "x", "y", "xy"};
    if (D == 3 || keys.everything()) axes.insert(axes.end(), {"z", "xz", "yz", "xyz"});
    keys.choice(
        {.path = "domain.periodic", .meaning = "axes along which what leaves on one side comes back on the other"},
        c.domain.periodic, axes);
    if (c.domain.periodic != "none" || keys.everything()) {
        if (c.domain.centre.empty()) c.domain.centre.assign(static_cast<std::size_t>(D), 0.0);
        keys.numbers({.path = "domain.centre", .unit = "m", .meaning = "of the periodic box"}, c.domain.centre, D);
        keys.numbers({.path = "domain.size",
                      .unit = "m",
                      .meaning = "edges of the periodic box; along other axes they mean nothing",
                      .above = 0,
                      .required = true},
                     c.domain.size, D);
    }
}

}  // namespace coronet
