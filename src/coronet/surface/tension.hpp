// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surface tension as a force per area on the particles of the free surface, Lobo (2011) Eq 3.51,
//     f_i = -sigma kappa_i n_i A_i,
// with normal, curvature and the share A_i of the surface from the surface particles around (surface/reconstruct.hpp).
// The printed equation lacks the area, and was added to an acceleration. Units: N (N per metre of depth in 2D).
//
// Nothing makes the sum of these forces vanish: momentum drifts. Chapter 5 there takes their mean off every one of them;
// then momentum is kept, angular momentum is not.

#include "coronet/surface/reconstruct.hpp"

namespace coronet {

/// How the free surface is found, and what acts there.
struct SurfaceSettings {
    double tension = 0;          ///< sigma [N/m]
    double spacing = 0;          ///< of the particles [m]
    double coverage_radius = 0;  ///< [m], of surface/detect.hpp
    SurfaceFit fit{0};
    bool remove_mean_force = false;
};

/// Sets Surface, SurfaceNormal, Curvature, SurfaceArea and SurfaceFitted.
template <int D>
void find_surface(Particles<D>& particles, Neighbours<D> const& neighbours, SurfaceSettings const& settings);

/// Adds the tension of the surface found to Acceleration.
template <int D>
void add_tension(Particles<D>& particles, SurfaceSettings const& settings);

/// The longest stable step [s] for capillary waves as short as a surface of particles has them: Brackbill, Kothe and
/// Zemach, J. Comput. Phys. 100 (1992) 335, Eq 61, with a void outside. rho in kg/m^3.
double capillary_step(SurfaceSettings const& settings, double rho);

}  // namespace coronet
