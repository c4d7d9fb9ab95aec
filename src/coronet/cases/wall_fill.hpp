// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lays wall particles on the lattice of the liquid: all points of the solid, the union of the case's walls, from which
// liquid at the surface can be seen, each with its mirror (wall_mirror.hpp). A wall that moves is a solid of its own,
// and those at rest are another: particles and mirrors of each stay right wherever the others go.

#include <vector>

#include "coronet/cases/wall_shape.hpp"
#include "coronet/kernels/kernel.hpp"
#include "coronet/neighbours/images.hpp"

namespace coronet {

template <int D>
PeriodicBox<D> periodic_box(Case const& c);

/// Whether x [m] is in the box as far as that is periodic: its lower faces belong to it, the upper ones do not.
template <int D>
bool is_in(PeriodicBox<D> const& box, Vector<double, D> const& x, double slack) {
    bool in = true;
    for (int k = 0; k < D; ++k) {
        double const from_low = x[k] - box.low[k];
        in = in && (!box.periodic[k] || (from_low >= -slack && from_low < box.size[k] - slack));
    }
    return in;
}

/// sum V grad W (x_j - x_i)^T over all points of the case's lattice, a multiple of I.
template <int D>
double lattice_slope_moment(Case const& c, Kernel const& kernel);

/// Whether a wall moves as a whole.
bool moves(Wall const& wall);

template <int D>
class Solid {
public:
    /// Of all walls, or of those that move with `one`.
    explicit Solid(Case const& c, Wall const* one = nullptr);
    /// Of the walls that do not move as a whole, which may be none.
    static Solid at_rest(Case const& c);

    bool holds(Vector<double, D> const& x) const { return deepest(x).depth > -slack_; }
    double slack() const { return slack_; }

    struct Depth {
        double depth = -1e300;  ///< below the surface of the wall in which x is deepest [m]
        Vector<double, D> normal;
        std::size_t wall = 0;
    };
    Depth deepest(Vector<double, D> const& x) const;

private:
    std::vector<Wall> const& walls_;
    std::vector<std::size_t> own_;  // which of them
    double slack_;                  // what is on the surface but for round-off is in the solid
};

template <int D>
struct WallSeeds {
    std::vector<Vector<double, D>> position, to_mirror;  ///< [m]
    std::vector<std::size_t> wall;                       ///< which of the case's

    std::size_t size() const { return position.size(); }
};

template <int D>
WallSeeds<D> fill_walls(Case const& c);

}  // namespace coronet
