// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The boundary of a liquid in 3D (boundary.hpp), from the mesh through its surface particles (mesh.hpp). With V the
// volume of a particle, N_v the vector area of the triangles around vertex v, A_v their area, and s_v a third of that,
// averaged over the vertex and those around it,
//     X_v = x_v + V/(2 s_v) A_v N_v/|N_v|^2
// are the corners of the boundary; the area of its triangles is `size`, the volume within `content`. s_v is the share
// of the surface of one particle, so V/s_v how thick the layer is that they form, of which half lies outside of them.
// A_v/|N_v| is the inverse cosine of the angle between triangles and normal: so each triangle moves out by that half
// along its own normal, at edges and corners, too, and what is added is half a V for each particle of the surface.
//
// The derivatives are those of this very rule, by the chain rule backwards: from corners to s_v, A_v and N_v, from
// these to the areas of triangles, from these to particles. A mesh that has been found keeps its triangles while
// particles move; where it is found anew, size and content jump.
//
// In a liquid that is periodic along an axis, size and content are those of one period (mesh.hpp): the volume is the
// flux of a field that points across the period, r/2 from the axis instead of x/3.
//
// Bounds: s_v counts as no less than half a spacing squared, so that the boundary is no more than a spacing out where
// surface particles crowd; and |N_v| as no less than half of A_v, where the mesh folds back on itself.

#include "coronet/surface/boundary.hpp"
#include "coronet/surface/mesh.hpp"

namespace coronet {

/// Sets Surface, too: 1 on the boundary and 0 elsewhere. coverage_radius [m] is that of the mesh, spacing [m] and
/// volume [m^3] those of the particles.
Boundary<3> boundary_of(SurfaceMesh const& mesh, Particles<3>& particles, Neighbours<3> const& neighbours,
                        double coverage_radius, double spacing, double volume);

/// The corners X_v alone [m].
std::vector<Vector<double, 3>> boundary_corners(SurfaceMesh const& mesh, Particles<3> const& particles, double spacing,
                                                double volume);

}  // namespace coronet
