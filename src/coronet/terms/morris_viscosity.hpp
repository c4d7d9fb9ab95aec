// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The viscous force of Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214, Eq 22, for a constant viscosity eta:
//     dv_i/dt = 1/rho_i sum_j V_j 2 eta (x_ij . grad W_ij)/r^2 v_ij.
// It needs no velocity gradient, so one sweep serves pressure, viscosity and continuity. Linear momentum is conserved
// and energy only removed; angular momentum is not conserved, since the force is along v_ij and not along x_ij.
//
// Morris has r^2 + 0.01 h^2 below, which takes half a percent off the viscosity, whatever the spacing. It is not
// needed: grad W = F x with an F that stays finite where particles meet.
//
// With corrected kernels (Jahanbakhsh et al., 7th SPHERIC workshop, 2012, Eq 18) grad W_ij becomes
//     (grad W~_ij - grad W~_ji)/2 = ((L_i + L_j) grad W_ij - (q_i - q_j) W_ij)/2.
// In print there is a plus, for which the mean vanishes with plain kernels, and no division by r^2. Where the
// correction is strong, the force of a pair may give energy, which it never does with plain kernels.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct MorrisViscosity {
    double eta = 0;  ///< dynamic viscosity [Pa s]

    using reads = Fields<Volume, Velocity>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        return give<gives>(ij, (R(2 * eta) * (1.0 / ij.i.rho) * (ij.j.V * ij.F)) * (ij.i.v - ij.j.v));
    }
};

/// With 4 mu_i mu_j/(mu_i + mu_j) for 2 eta: between two particles one stress acts, mu_i g_i = mu_j g_j, so that what
/// resists their difference in velocity is the harmonic mean (Cleary and Monaghan, J. Comput. Phys. 148 (1999) 227, for
/// heat). The arithmetic one would let a plug of a yielding liquid stiffen its neighbours.
struct VariableMorrisViscosity {
    using reads = Fields<Volume, Velocity, Viscosity>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const eta = R(4) * ij.i.mu * ij.j.mu / ((ij.i.mu + ij.j.mu) * ij.i.rho);
        return give<gives>(ij, (eta * (ij.j.V * ij.F)) * (ij.i.v - ij.j.v));
    }
};

struct CorrectedMorrisViscosity {
    double eta = 0;  ///< dynamic viscosity [Pa s]

    using reads = Fields<Volume, Velocity, SlopeCorrection, ValueCorrection>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const along = dot(ij.x, (ij.i.L + ij.j.L) * ij.gradW) - ij.W * dot(ij.x, ij.i.q - ij.j.q);  // twice x . grad
        // W x . q/r^2 is not finite where particles meet.
        R const inverse_square = 1.0 / largest(ij.r2, R(1e-4) * ij.h * ij.h);
        return give<gives>(ij, (R(eta) * (1.0 / ij.i.rho) * (ij.j.V * along * inverse_square)) * (ij.i.v - ij.j.v));
    }
};

}  // namespace coronet
