// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The outline of a liquid in 2D: its surface particles in order. The boundary of the union of all discs of the coverage
// radius is made of the gaps that neighbours leave on each disc (arc_coverage.hpp): the gap of i that ends where the
// arc of b begins goes over into the gap of b that begins where the arc of i ends. So gaps link into closed loops,
// counter-clockwise around a piece of liquid, clockwise around a void; a particle that has liquid on two sides is on
// them twice. Where three circles meet in a point, to the tolerances of cap.hpp, two gaps may disagree about who comes
// between: ends without a beginning then go on at the nearest beginning without an end, of which there are as many.
//
// The liquid reaches farther than its outermost particles, by half a spacing d. The polygon through a loop is moved
// out by it: its sides along their normals, its corners to where the moved sides meet. With sides s and angles a
// between them (negative where the outline turns inwards) the area becomes
//     A + d sum s + d^2 sum tan(a/2),
// for convex and other polygons alike. Corners sharper than a right angle are cut off (to the end of a row of
// particles, half a cell); a lone particle is the square of its cell. What a lattice lays in rows is thus exactly its
// cells. On a smooth surface, particles s apart, sides are chords: the area is too small by s^2/6 of pi times the
// square of the spacing over the radius; and d counts as the papers' half of a spacing, whatever the rows are like
// (along a lattice's diagonal the cells reach only 0.35 of a spacing beyond their centres).

#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

using Polygon = std::vector<Vector<double, 2>>;

/// One closed line of the boundary.
struct Loop {
    std::vector<Index> particles;  ///< in order; liquid lies to the left
    double area;                   ///< within the boundary of the discs [m^2]: negative for a void
};

struct Outline {
    std::vector<Loop> loops;
    std::size_t particles = 0;  ///< of the surface, each counted once

    /// The number of the loop around the largest piece; -1 if there is no particle.
    int largest() const;
    int voids() const;
};

/// `radius` is the coverage radius [m]; throws CaseError if the lists of neighbours do not reach twice as far.
Outline find_outline(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius);

/// The same where none but the `candidates` can be of the surface.
Outline find_outline(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius,
                     Targets const& candidates);

/// The particles that can be of the surface until neighbours are listed anew. Now and later, two that can meet are
/// within a skin of how far apart they were at the last listing: within two skins of how far they are now. So a circle
/// that its neighbours cover with discs smaller by that stays covered.
Targets surface_candidates(Particles<2> const& particles, Neighbours<2> const& neighbours, double radius);

/// A closed polygon with the liquid on its left, moved out by d [m].
Polygon moved_out(Polygon line, double d);

struct PolygonMeasures {
    double area = 0, perimeter = 0;  ///< [m^2], positive if counter-clockwise; [m]
    Vector<double, 2> centroid;      ///< [m]
};
PolygonMeasures measure(Polygon const& line);

}  // namespace coronet
