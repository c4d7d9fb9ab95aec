// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force of the liquid on each wall particle. The forces between pairs are equal and opposite, so the law that moves
// the liquid, swept from the wall's side over the liquid that sees it, gives what the wall takes: with the field
// WallForce, their sum is the momentum that the liquid has lost to the wall, to round-off.

#include "coronet/schemes/weakly_compressible.hpp"

namespace coronet {

/// Sets WallForce [N], of a state for which what the force sweep reads is up to date.
template <int D>
void find_wall_forces(Particles<D>& particles, Neighbours<D> const& neighbours,
                      typename WeaklyCompressible<D>::Settings const& settings);

}  // namespace coronet
