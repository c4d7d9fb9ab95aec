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
// the plain SPH form (Eq 80) has T = sigma, s = 0. In the corrected form the part of i needs only sums that its
// gradient has formed already, G0 = sum_j V_j grad W_ij and W0 = sum_j V_j W_ij over the neighbours, so the pair loop
// is left with
//     dv_i/dt = own_i + 1/rho_i sum_j ((V T)_j grad W_ij + (V s)_j W_ij),   own_i = (T_i G0_i - s_i W0_i)/rho_i.

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
    using reads = Fields<CorrectedStress, StressOffset>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    /// own_i, of the sums over the neighbours.
    template <class R, int D>
    CORONET_HD static Vector<R, D> own_part(Matrix<R, D> const& T, Vector<R, D> const& s, R rho, Vector<R, D> const& G0,
                                            R W0) {
        return (R(1) / rho) * (T * G0 - W0 * s);
    }
    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        auto const per_rho = 1.0 / ij.i.rho;
        return give<gives>(ij, ij.j.VT * ((per_rho * ij.F) * ij.x) + (per_rho * ij.W) * ij.j.Vs);
    }
};

}  // namespace coronet
