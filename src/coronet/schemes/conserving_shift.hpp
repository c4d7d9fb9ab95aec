// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keeps particles evenly spaced: after each step those nearer than a range a are moved apart by a share of what they
// lack,
//     d_i = sum_j m_j/(m_i + m_j) (a - r_ij)_+ x_ij/r_ij,
// those of the surface not outwards; and of all displacements that is taken which comes nearest to d in the norm of the
// masses and leaves the centre of mass and, to first order, the size S and the content C of the boundary of each piece
// of liquid (surface/boundary.hpp) as they were:
//     d <- d - M^-1 (s grad S + c grad C).
// So shifting neither spreads a surface nor takes or gives surface energy.
//
// Velocities follow the flow to where particles are put, v <- v + grad v d, or else they would diffuse; then a rigid
// motion of each piece, of the order of the error of grad v, gives back its momentum and angular momentum to round-off;
// in a liquid that is periodic along an axis the moment about that one, the only one there is.

#include <vector>

#include "coronet/neighbours/neighbours.hpp"
#include "coronet/surface/boundary.hpp"

namespace coronet {

template <int D>
class ConservingShift {
public:
    explicit ConservingShift(double range) : range_(range) {}  ///< a [m]

    /// Finds d for the positions as they are; the lists must be those of now.
    void find(Particles<D> const& particles, Neighbours<D> const& neighbours);
    /// Moves the particles. boundary is that of where d was found.
    void apply(Particles<D>& particles, Neighbours<D> const& neighbours, Boundary<D> const& boundary);

    static constexpr double share = 0.5;  ///< of d, a step

private:
    void keep_size_and_content(Particles<D> const& particles, Boundary<D> const& boundary);
    static Matrix<double, D> gradient(View<D> const& view, Neighbours<D> const& neighbours, std::size_t i);

    double range_;
    std::vector<Vector<double, D>> shift_, change_;
};

}  // namespace coronet
