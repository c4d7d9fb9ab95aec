// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force of the stress, Fang et al. (2009) Eq 61: with interpolation coefficients C_ij = V_j grad W~_ij,
//     dv_i/dt = 1/m_i sum_j (V_i sigma_i C_ij - V_j sigma_j C_ji),
// the dual of the velocity gradient: what the force does to the particles, the stress dissipates or stores. It is
// antisymmetric in i and j, so momentum is conserved to round-off; if the gradient is exact for linear fields, angular
// momentum is, too.
//
// With grad W~_ij = L_i grad W_ij - q_i W_ij (terms/gradient_correction.hpp), T = sigma L and s = sigma q it reads
//     dv_i/dt = 1/rho_i sum_j V_j ((T_i + T_j) grad W_ij + (s_j - s_i) W_ij);
// the plain SPH form (Eq 80) has T = sigma, s = 0.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct StressDivergence {
    using reads = Fields<Volume, Stress>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, (ij.j.V * (1.0 / ij.i.rho)) * ((ij.i.sigma + ij.j.sigma) * ij.gradW));
    }
};

struct CorrectedStressDivergence {
    using reads = Fields<Volume, CorrectedStress, StressOffset>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, (ij.j.V * (1.0 / ij.i.rho)) * ((ij.i.T + ij.j.T) * ij.gradW + ij.W * (ij.j.s - ij.i.s)));
    }
};

}  // namespace coronet
