// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a wall is, seen from any point: how far, and which way the liquid lies. That is all that is asked of a shape
// that may bound a solid.

#include "coronet/cases/case.hpp"
#include "coronet/core/tensor.hpp"

namespace coronet {

template <int D>
struct WallPoint {
    double distance;           ///< to the nearest point of the surface, below 0 in the solid [m]
    Vector<double, D> normal;  ///< from the solid to the liquid, there
};

template <int D>
WallPoint<D> nearest_wall_point(Wall const& wall, Vector<double, D> const& x);

/// Half the edges of a box along the axes around the wall's centre that holds its surface [m].
template <int D>
Vector<double, D> half_extents(Wall const& wall);

}  // namespace coronet
