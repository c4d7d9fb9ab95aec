// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keeps particles evenly spaced: after each step those nearer than a range a are moved apart by a share of what they
// lack,
//     d_i = k sum_j m_j/(m_i + m_j) (a - r_ij)_+ x_ij/r_ij,
// and of all displacements that is taken which comes nearest to d in the norm of the masses and leaves, to first order
// in d, the size and the content of the boundary of each piece of liquid (surface/boundary.hpp) and, exactly, the angular
// momentum as they were,
//     d <- d - M^-1 C (C^T M^-1 C)^+ C^T d,
// the columns of C being the derivatives of these. Pairs move about their centre of mass, and the columns sum to zero:
// the centre of mass stays. So, other than shifting along a gradient of concentration, it needs no special treatment of
// the surface, and takes nothing from any conserved quantity. Velocities stay with their particles.
//
// k is how far the fastest particle moves in the step, in spacings (as in Xu, Stansby and Laurence, J. Comput. Phys. 228
// (2009) 6703), at most a half: at rest nothing is shifted.

#include <span>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"
#include "coronet/surface/boundary.hpp"

namespace coronet {

template <int D>
class ConservingShift {
public:
    /// range and spacing in m.
    ConservingShift(double range, double spacing) : range_(range), spacing_(spacing) {}

    /// Finds d without k for the positions as they are; the lists must be those of now.
    void find(Particles<D> const& particles, Neighbours<D> const& neighbours);
    /// Moves the particles. boundary is that of where they were found; step in s.
    void apply(Particles<D>& particles, Boundary<D> const& boundary, double step);

private:
    double range_, spacing_;
    std::vector<Vector<double, D>> shift_;
};

}  // namespace coronet
