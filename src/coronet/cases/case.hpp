// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A case: plain data that say what to simulate. SI units, angles in degrees. Every member is a key of the case file,
// described once in describe(), which reading, writing, checking and the reference page all share; but for what comes
// of the files that it names, a flow curve, a wall's surface or a frame.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coronet/cases/keys.hpp"
#include "coronet/materials/flow_curve.hpp"
#include "coronet/schemes/pair_terms.hpp"
#include "coronet/terms/central_viscosity.hpp"

namespace coronet {

struct Cut {
    std::vector<double> point, normal;
};

struct Shape {
    std::string kind = "disc";
    std::vector<double> centre;
    double radius = 1, length = 1;
    std::vector<double> size, semi_axes;
    double rotation = 0;
    double amplitude = 0;  ///< of a drop, and its mode: those of the section `drop`; of a column that of `column`
    int mode = 2;          ///< and there its number of waves
    std::vector<Cut> cuts;
};

class ClosedSurface;
struct Frame;

/// A wall: one side of a surface is solid.
struct Wall {
    std::string name, kind = "box", solid = "outside", slip = "none";
    std::vector<double> centre, size, semi_axes, corners;
    double radius = 1, rotation = 0;
    std::string file;
    double unit = 1;  ///< of the file [m]
    std::vector<std::string> surface_velocity, displacement;
    std::string turn = "0";
    std::shared_ptr<ClosedSurface const> surface;  ///< what the file holds
};

struct ProbeKeys {
    std::string kind = "value";
    std::string name, field = "pressure";
    std::vector<double> at;
    std::vector<std::string> rates, semi_axes;
    std::string side = "1", angular_velocity = "1", speed = "1";
    std::string flow = "steady", gap = "1", lower_velocity = "0", upper_velocity = "0", depth = "1", width = "1";
    int mode = 2, waves = 1;
    std::string wall, radius = "1";
    double sensor_width = 0;
};

struct Case {
    std::string name, title;
    int dimension = 2;
    std::map<std::string, double> parameters;
    std::vector<Shape> shapes;
    std::vector<Wall> walls;

    struct {
        std::string periodic = "none";
        std::vector<double> centre, size;
    } domain;

    struct {
        double amplitude = 0.05;
        int mode = 2;
    } drop;

    struct {
        double amplitude = 0;
        int waves = 1;
    } column;

    struct {
        double spacing = 0;
        std::string lattice = "square", origin = "node";
        double rotation = 0, jitter = 0;
        int seed = 1;
    } particles;

    struct {
        std::vector<std::string> velocity;
        std::string pressure = "0", from;
        std::shared_ptr<Frame const> frame;  ///< the liquid of what `from` names
    } initial;

    struct {
        double reynolds = 0, speed = 1, length = 1;
    } flow;

    struct : Rheology {
        std::string preset = "none", rheology, flow_curve, equation_of_state = "linear";
        double temperature = 20, glycerol_mass_fraction = unset, density = unset, surface_tension = unset,
               sound_speed = 0, tait_exponent = 7;
        std::vector<double> gravity;
        std::vector<std::string> body_force;
    } fluid;

    struct {
        std::string scheme = "weakly-compressible", gradient = "fpm", viscous_force = "stress",
                    kernel = "quintic-spline", precision = "double";
        double support = 3.9, skin = 0;
        CentralViscosity central_viscosity;
        PairTerms pair_terms;
        std::string viscous_step = "explicit", pressure_operator = "consistent", pressure_kernel,
                    preconditioner = "multigrid";
        std::string shifting = "none";
        double shift_range = 1, shifting_coefficient = 0;
        double pressure_support = 0, compact_share = 0.05, tolerance = 1e-3;
        int most_iterations = 1000;
        bool lattice_diagonal = false;
    } method;

    struct {
        std::string tension_force = "boundary", pressure = "mirrored", fit_weights = "compact";
        double coverage_radius = 1.2, fit_width = 2.5;
        bool remove_mean_force = false;
    } surface;

    struct {
        double end = 0, step = 0, courant = 0.25, settled = 0;
        std::string stepping = "predictor-corrector", position_update = "mean-velocity";
    } time;

    struct {
        double every = 0, series_every = 0;
        bool frames = true;
    } output;

    std::vector<ProbeKeys> probes;

    std::optional<FlowCurveFit> flow_curve_fit;
};

/// Shows every key of the case to the visitor, in the order of the file.
void describe(Keys& keys, Case& c);

}  // namespace coronet
