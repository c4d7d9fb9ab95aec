// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The boundary of the liquid as a function of the positions of its particles, with exact derivatives. The surface
// particles in order (outline.hpp) are the outermost, but half of what each of them stands for lies farther out. With V
// the volume of a particle, l_i the mean of the four sides of the outline nearest to i, and n_i the outward normal of
// the line through its neighbours there,
//     X_i = x_i + V/(2 l_i) n_i
// are the corners of the boundary; its length is `size`, the area within it `content`. Where the flow stretches the
// surface, the layer outside of the outermost particles grows thin, as it must: the boundary moves as the liquid
// there does. (With half a spacing everywhere it would move as the outermost particles do, less than the liquid: mode n
// of a drop of radius R then has an error of n times the spacing over R.) A row of single particles is a thread
// of the right volume. Where surface particles crowd to less than half a spacing, l is that: a boundary a spacing out.
// Where the outline turns back on itself, at the end of a thread, the line through the neighbours counts as no less
// than half as long as the two sides, and n is shorter than 1, down to nothing: derivatives stay finite.
//
// Neither changes when everything is shifted or turned: whatever the arrangement, their derivatives sum to zero over
// the particles, and so do the moments. A force that is a multiple of them conserves momentum and angular momentum to
// round-off, and its work is the change of the size or the content.
//
// Pieces of liquid that discs of the coverage radius do not join are told apart: each has its own size and content.

#include <numeric>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"
#include "coronet/surface/outline.hpp"

namespace coronet {

template <int D>
struct Boundary {
    std::size_t pieces = 0;
    std::vector<Index> piece;                            ///< that each particle belongs to
    std::vector<double> size, content;                   ///< of each piece [m, m^2]
    std::vector<Vector<double, D>> of_size, of_content;  ///< their derivatives by the position of each particle [1, m]

    double total_size() const { return std::accumulate(size.begin(), size.end(), 0.0); }
    double total_content() const { return std::accumulate(content.begin(), content.end(), 0.0); }
    std::size_t piece_of(std::size_t i) const { return static_cast<std::size_t>(piece[i]); }

    /// The sum of part(i) over the particles of each piece.
    template <class Part>
    std::vector<double> sums(Part const& part) const {
        if (pieces == 1) return {sum_over(piece.size(), 0.0, part)};
        std::vector<double> sums(pieces, 0.0);
        for (std::size_t i = 0; i < piece.size(); ++i) sums[piece_of(i)] += part(i);
        return sums;
    }
};

/// Sets Surface, too: 1 on the boundary and 0 elsewhere. coverage_radius as in detect.hpp, spacing [m] and volume [m^2]
/// those of the particles. Throws CaseError if the lists of neighbours do not reach twice the coverage radius.
Boundary<2> find_boundary(Particles<2>& particles, Neighbours<2> const& neighbours, double coverage_radius,
                          double spacing, double volume);

/// The same along an outline that has been found.
Boundary<2> boundary_along(Outline const& outline, Particles<2>& particles, Neighbours<2> const& neighbours,
                           double coverage_radius, double spacing, double volume);

/// The corners X of one loop of the outline, as for find_boundary. spacing [m], volume [m^2].
std::vector<Vector<double, 2>> boundary_corners(std::vector<Vector<double, 2>> const& loop, double spacing,
                                                double volume);

}  // namespace coronet
