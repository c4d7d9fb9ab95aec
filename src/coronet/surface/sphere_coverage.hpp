// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Is a sphere covered by the balls of its neighbours? Haque and Dilts, J. Comput. Phys. 226 (2007) 1710: each neighbour
// covers a cap, and the sphere is covered exactly if there is a cap and the circle around every cap is covered by
// the others. For the part that is not covered is open; unless it is the whole sphere it has a boundary, which is made
// of arcs of those circles, and nobody else covers them. On the circle of cap j, with unit vectors c n_j + s w around
// its axis n_j, the cap n_k . u >= c_k is the arc
//     w . (s n_k) >= c_k - c n_j . n_k
// in the plane of w, so the arcs of the plane (arc_coverage.hpp) decide. Caps are closed, with the tolerance of
// cap.hpp. Caps that are alike to `Cap::apart` would cover each other's circles: only the first of them is asked.
//
// That takes the square of the number of caps. Most spheres are decided before, on cells that tile the sphere: if each
// lies in one cap as a whole it is covered, and if the middle of one lies in no cap it is not. Else only circles
// that pass through a cell in doubt are asked: what is not covered lies in those cells, and so does its boundary.

#include <vector>

#include "coronet/surface/arc_coverage.hpp"

namespace coronet {

/// The caps of one sphere. Meant to be used for one sphere after the other: it keeps its memory.
class SphereCoverage {
public:
    void clear() {
        caps_.clear();
        seen_ = 0;
        everything_ = false;
    }

    /// The sphere's part within `cap` is covered.
    void add(Cap<3> const& cap, Index neighbour = 0);

    /// Enough to know that the sphere is covered, if it is with some overlap: each of its cells lies in one cap.
    bool seems_covered();
    bool covered();
    /// The same as covered(), by the circles alone: slow, to compare with.
    bool circles_are_covered();

private:
    struct Disc {
        Vector<double, 3> n;  ///< of length 1
        double c, s;          ///< cosine and sine of its angular radius
    };
    enum class Answer { covered, open, unknown };
    Answer ask_cells();
    float const* look_at_cells();
    bool in_doubt(Disc const& cap) const;  ///< its circle passes through one of the doubtful cells
    bool is_covered(Disc const& cap);      ///< its circle is, by the others

    std::vector<Disc> caps_;
    std::size_t seen_ = 0;       // caps that the cells know
    std::vector<float> inside_;  // of each cell: how far it is in a cap, at best; negative: outside
    bool everything_ = false;
    std::vector<Vector<double, 3>> doubtful_;  // middles of cells that lie in no cap as a whole
    ArcCoverage circle_;
};

}  // namespace coronet
