// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The shifting vectors that look at distances: particles within a reach push by the square of their nearness,
//     R_i = sum_j (a/r_ij)^2 n_ij,
// with n_ij the unit vector from j to i (in print it may be either): a particle moves away from those nearest to it.
//     xu           reach: the support, a: the mean distance of those within it. Xu, Stansby and Laurence, J. Comput.
//     Phys.
//                  228 (2009) 6703; Jahanbakhsh et al. (7th SPHERIC workshop, 2012) Eq 21. At a free surface neighbours
//                  are on one side, and R points out of it.
//     jahanbakhsh  reach and a: the initial spacing. Jahanbakhsh et al. Eqs 22 and 23. Only what is nearer than it was
//     at
//                  the start pushes, so that a surface that is stretched is left alone.
// Dimensionless. No kernel makes these sums vanish at the edge: a pair counts inside the reach only. A distance counts
// as at least a hundredth of the smoothing length: R stays finite where particles meet.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct DistanceShift {
    static constexpr bool respects_surface = false;

    double reach;  ///< [m]
    double a;      ///< [m]; 0: the mean distance

    /// In print the unit step of Eq 23 is 1 at 0: then every pair of a lattice would push, or not, as rounding has it.
    /// Here a pair pushes if it is nearer than the initial spacing by a millionth.
    static DistanceShift xu(double support) { return {support, 0}; }
    static DistanceShift jahanbakhsh(double spacing) { return {(1 - 1e-6) * spacing, spacing}; }

    using reads = Fields<>;
    using own = Fields<>;
    using gives = Fields<Repulsion, NeighbourCount, DistanceSum>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const inside = select(ij.r2 < R(reach * reach), R(1), R(0));
        auto const [r, per_r] = roots(largest(ij.r2, R(1e-4) * ij.h * ij.h));
        return give<gives>(ij, (inside * per_r * per_r * per_r) * ij.x, inside, inside * r);
    }

    /// R of the sums.
    template <class R, int D, class List>
    CORONET_HD Vector<R, D> vector(Values<R, D, List> const& sums) const {
        R const length = a > 0 ? R(a) : sums.distances / largest(sums.count, R(1));
        return (length * length) * sums.repulsion;
    }
};

}  // namespace coronet
