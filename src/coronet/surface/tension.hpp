// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surface tension as a force on the particles of the free surface, in N (N per metre of depth in 2D).
//
// `boundary`: minus the derivative of sigma times the length P of the boundary, in 3D its area (surface/boundary.hpp,
// surface/mesh_boundary.hpp),
//     f_i = -sigma dP/dx_i:
// in 2D sigma pulls along each side of a polygon at both of its ends. Momentum and angular momentum are conserved to
// round-off on any arrangement, and the work done is the loss of sigma P. The pressure that balances it must not be
// felt by the outermost particles through their truncated surroundings, which would push them out until they crowd: its
// mean acts on the boundary as well, p_mean dA/dx_i, and only what exceeds the mean acts between particles.
//
// `curvature`: Lobo (2011) Eq 3.51,
//     f_i = -sigma kappa_i n_i A_i,
// with normal, curvature and the share A_i of the surface from the surface particles around (surface/reconstruct.hpp).
// The printed equation lacks the area, and was added to an acceleration. Nothing makes the sum of these forces vanish:
// momentum drifts. Chapter 5 there takes their mean off every one of them; then momentum is kept, angular momentum not.

#include "coronet/surface/boundary.hpp"
#include "coronet/surface/reconstruct.hpp"

namespace coronet {

enum class TensionForce { boundary, curvature };

/// How the free surface is found, and what acts there.
struct SurfaceSettings {
    double tension = 0;                            ///< sigma [N/m]
    TensionForce force = TensionForce::curvature;
    double spacing = 0;                            ///< of the particles [m]
    double volume = 0;                             ///< of one of them [m^D]
    double coverage_radius = 0;                    ///< [m], of surface/detect.hpp
    SurfaceFit fit{0};
    bool remove_mean_force = false;

    bool acts_on_boundary() const { return tension > 0 && force == TensionForce::boundary; }
};

/// Sets Surface, SurfaceNormal, Curvature, SurfaceArea and SurfaceFitted.
template <int D>
void find_surface(Particles<D>& particles, Neighbours<D> const& neighbours, SurfaceSettings const& settings);

/// Adds to Acceleration the tension of the surface found, from its curvatures.
template <int D>
void add_tension(Particles<D>& particles, SurfaceSettings const& settings);

/// Adds to Acceleration the tension of a boundary.
template <int D>
void add_tension(Particles<D>& particles, Boundary<D> const& boundary, double sigma);

/// The longest stable step [s] for capillary waves as short as a surface of particles has them: Brackbill, Kothe and
/// Zemach, J. Comput. Phys. 100 (1992) 335, Eq 61, with a void outside. rho in kg/m^3.
double capillary_step(SurfaceSettings const& settings, double rho);

}  // namespace coronet
