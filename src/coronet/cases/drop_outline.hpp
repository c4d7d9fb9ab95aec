// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is seen of a drop in 2D from outside: the line around its largest piece, about its centroid. With tension on the
// boundary it is that boundary (surface/boundary.hpp), V/(2 l) outside of the outermost particles: where they crowd,
// less of each is left to lie outside of them. Else the outline (surface/outline.hpp), moved out by half a spacing.

#include <complex>

#include "coronet/cases/case.hpp"
#include "coronet/surface/outline.hpp"

namespace coronet {

struct DropOutline {
    Polygon line;                       ///< from the centroid [m]
    double area = 0;                    ///< inside, voids not taken off [m^2]
    std::size_t surface_particles = 0;  ///< around voids and other pieces, too
    int voids = 0;
    double nearest = 0, farthest = 0, mean_radius = 0;  ///< [m]; the mean is over the polar angle
    double spacing_p01 = 0;  ///< all but 1 % of the particles have their nearest neighbour farther away [spacings]
};

/// With the coverage radius of the case, up to twice of which spacing_p01 goes.
DropOutline drop_outline(Particles<2> const& particles, Case const& c);

/// a exp(-i n theta0) [m] of a line r = R + a cos(n (theta - theta0)), that is the integral of r exp(-i n theta)/pi
/// over theta, with r linear in theta between corners. An arrangement of corners on a circle thus has none; waves are
/// too small by (n d)^2/12, d the angle between corners.
std::complex<double> mode_of(Polygon const& line, int n);

}  // namespace coronet
