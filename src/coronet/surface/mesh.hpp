// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The closed mesh of triangles through the surface particles of a liquid in 3D: the boundary of their alpha shape,
// Edelsbrunner and Muecke, ACM Trans. Graph. 13 (1994) 43. Three particles are a triangle if a ball of the coverage
// radius can touch them from outside without a fourth inside it.
//
// It is found without a triangulation of all particles, as the dual of the boundary of the union of all balls of that
// radius, the outline's (outline.hpp) with a dimension more. The spheres of i and j meet in a circle, of which the
// balls of others leave gaps (arc_coverage.hpp). A gap is an edge of the mesh between two triangles: at its beginning,
// where the ball of k ends, that of i, j and k, at its end, where the ball of l begins, that of j, i and l. So every
// edge has two triangles by construction, and the mesh is closed. Triangles follow each other around a particle in
// fans, each of which is a vertex: a particle that has liquid on two sides, as in a sheet of one layer, is two of them.
//
// What is exactly on a ball, as four particles of a lattice's face are, is decided by particles that are moved, for
// that alone, by 1e-5 radii at random. Deciding which triangles there are is costly, and need not be done as often as
// the positions change: a mesh stays closed however its particles move.
//
// Across a periodic boundary the mesh goes on: an image counts as its original, so vertices are particles of the liquid
// and every triangle is there once. What lies across the boundary is nearer by a period: its triangles must be measured
// by the ways between their corners, each to the nearest copy, which the period decides by being wider than two
// supports. A column as long as the period is closed, as a tube is whose ends are joined.

#include <array>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

struct SurfaceMesh {
    std::vector<Index> particle;                  ///< of each vertex
    std::vector<std::array<Index, 3>> triangles;  ///< their vertices, counter-clockwise seen from outside
    /// A corner is 3 times its triangle plus its place there; those of a vertex v, one after the other around it, are
    /// corners[first[v]] ... corners[first[v + 1] - 1].
    std::vector<Index> first, corners;
    PeriodicBox<3> box;       ///< in which it repeats itself
    bool has_strays = false;  ///< whether there is liquid without triangles that may be apart from the rest

    std::size_t vertices() const { return particle.size(); }
    /// Calls visit(triangle, place) for the corners of a vertex.
    template <class Visit>
    void for_corners(std::size_t vertex, Visit const& visit) const {
        for (Index c = first[vertex]; c < first[vertex + 1]; ++c) {
            auto const corner = static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]);
            visit(corner / 3, corner % 3);
        }
    }
    /// The number of each triangle's part of the mesh, which do not touch, counted from 0.
    std::vector<Index> parts() const;
};

/// `radius` is the coverage radius [m]. Lone particles and rows of them have no triangles. Throws CaseError if the
/// lists of neighbours do not reach twice as far, RunError if particles are where no mesh can tell them apart.
SurfaceMesh find_mesh(Particles<3> const& particles, Neighbours<3> const& neighbours, double radius);

}  // namespace coronet
