// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which particles are of the free surface: those whose circle (sphere) of the coverage radius is not covered by the
// circles of their neighbours. Dilts (2000) in 2D, Haque and Dilts (2007) in 3D; Lobo (2011), 3.2.1. A purely geometric
// rule, with one number: a void is seen as such if a ball of the coverage radius fits in without touching the
// centre of any particle.

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

/// Throws CaseError if discs of that radius [m] may meet farther apart than neighbours are known.
void check_coverage_radius(double radius, double known);

/// Sets Surface to 1 for the particles of the free surface and to 0 for the others. `radius` is the coverage radius
/// [m] of all of them; throws CaseError if the lists of neighbours do not reach twice as far.
template <int D>
void mark_surface(Particles<D>& particles, Neighbours<D> const& neighbours, double radius);

}  // namespace coronet
