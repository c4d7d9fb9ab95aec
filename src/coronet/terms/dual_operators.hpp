// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Divergence and pressure force that are each other's negative transpose (Fang et al. 2009, Eqs 46 and 52), in the
// forms that an iterative solve sweeps many times: a pair reads as little as can be, and what depends on i alone is
// added afterwards. With the corrected gradient grad W~_ij = L_i grad W_ij - q_i W_ij (terms/gradient_correction.hpp),
// C_ij = V_j grad W~_ij and g_i = sum_j C_ij over the neighbours,
//     div_i(v) = sum_j (V v)_j . grad W~_ij - v_i . g_i,
//     dv_i/dt  = -(1/rho_i) (p_i g_i + sum_j (V p)_j (L_j grad W_ij + q_j W_ij)).
// The latter's sum with L = I, q = 0 is PressurePush; in general it is CorrectedStressDivergence with sigma = -p I.

#include "coronet/pairs/law.hpp"

namespace coronet {

/// The plain divergence's sum over the neighbours.
struct PlainDivergence {
    using reads = Fields<WeightedVelocity>;
    using own = Fields<>;
    using gives = Fields<Divergence>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, ij.F * dot(ij.j.Vv, ij.x));
    }
};

/// The corrected one's.
struct CorrectedDivergence {
    using reads = Fields<WeightedVelocity>;
    using own = Fields<GradientMatrix, GradientOffset>;
    using gives = Fields<Divergence>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, ij.F * dot(ij.j.Vv, ij.i.L * ij.x) - ij.W * dot(ij.j.Vv, ij.i.q));
    }
};

/// The pressure of the neighbours with plain gradients: -(1/rho_i) sum_j (V p)_j grad W_ij.
struct PressurePush {
    using reads = Fields<WeightedPressure>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, (-1.0 / ij.i.rho * (ij.j.Vp * ij.F)) * ij.x);
    }
};

/// sum_j V_j/rho_j |grad W~_ij|^2: the neighbours' part in the diagonal of the divergence of the pressure force.
struct GradientSquares {
    using reads = Fields<Volume, Density>;
    using own = Fields<GradientMatrix, GradientOffset>;
    using gives = Fields<SquaredGradients>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        auto const gradient = ij.F * (ij.i.L * ij.x) - ij.W * ij.i.q;
        return give<gives>(ij, ij.j.V / ij.j.rho * norm2(gradient));
    }
};

}  // namespace coronet
