// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is seen of a drop in 3D from outside: the boundary (surface/mesh_boundary.hpp) of its largest piece, from its
// centroid.

#include "coronet/cases/case.hpp"
#include "coronet/fields/particles.hpp"

namespace coronet {

struct DropSurface {
    double volume = 0;                  ///< inside, voids not taken off [m^3]
    std::size_t surface_particles = 0;  ///< around voids and other pieces, too
    int voids = 0;
    double nearest = 0, farthest = 0, mean_radius = 0;  ///< of its corners [m]; the mean is over the solid angle
    double spacing_p01 = 0;  ///< all but 1 % of the particles have their nearest neighbour farther away [spacings]
};

/// With the coverage radius of the case, up to twice of which spacing_p01 goes.
DropSurface drop_surface(Particles<3> const& particles, Case const& c);

}  // namespace coronet
