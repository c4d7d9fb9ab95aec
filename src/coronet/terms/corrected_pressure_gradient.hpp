// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force of the pressure alone with the corrected gradient, Jahanbakhsh et al. (7th SPHERIC workshop, 2012) Eq 19
// without its viscous force, the case sigma = -p I of Fang et al. (2009) Eq 61 (in print the signs of 19 are turned):
//     dv_i/dt = -1/rho_i sum_j V_j (p_i grad W~_ij - p_j grad W~_ji)
//             = -1/rho_i sum_j V_j ((p_i L_i + p_j L_j) grad W_ij + (p_j q_j - p_i q_i) W_ij),
// L and q of terms/gradient_correction.hpp. Momentum and angular momentum are conserved to round-off. It is the
// corrected stress divergence in a form that reads L and q, which the viscous force beside it needs, too.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct CorrectedPressureGradient {
    using reads = Fields<Volume, Pressure, SlopeCorrection, ValueCorrection>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        auto const slope = (ij.i.p * ij.i.L + ij.j.p * ij.j.L) * ij.gradW;
        auto const value = ij.W * (ij.j.p * ij.j.q - ij.i.p * ij.i.q);
        return give<gives>(ij, (-1.0 / ij.i.rho * ij.j.V) * (slope + value));
    }
};

}  // namespace coronet
