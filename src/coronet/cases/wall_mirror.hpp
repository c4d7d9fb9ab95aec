// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a wall particle looks at the liquid from: its mirror image beyond the surface of the solid. It is found by
// reflecting the particle at the wall that it is deepest in, until it is in none: in a corner of two walls twice.
//
// Where walls touch, as an obstacle that stands on a floor, what is nearest may be a surface that another wall covers.
// If reflecting ends in the solid for that, the nearest point outside of it is looked for instead, on a lattice of half
// spacings, and the particle is reflected at the surface on the way there.

#include <optional>

#include "coronet/cases/wall_fill.hpp"

namespace coronet {

/// x is in the solid; dx is the spacing, reach the radius of the kernel [m]. None if within reach of x all is solid.
template <int D>
std::optional<Vector<double, D>> mirror_of(Solid<D> const& solid, PeriodicBox<D> const& box, Vector<double, D> const& x,
                                           double dx, double reach);

}  // namespace coronet
