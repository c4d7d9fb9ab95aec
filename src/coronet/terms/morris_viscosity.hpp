// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The viscous force of Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214, Eq 22, for a constant viscosity eta:
//     dv_i/dt = 1/rho_i sum_j V_j 2 eta (x_ij . grad W_ij)/(r^2 + 0.01 h^2) v_ij.
// It needs no velocity gradient, so one sweep serves pressure, viscosity and continuity. Linear momentum is conserved
// and energy only removed; angular momentum is not conserved, since the force is along v_ij and not along x_ij.

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
        R const slope = (ij.j.V * ij.F) * (ij.r2 * ij.soft);  // V x . grad W/(r^2 + 0.01 h^2)
        return give<gives>(ij, (R(2 * eta) * (1.0 / ij.i.rho) * slope) * (ij.i.v - ij.j.v));
    }
};

}  // namespace coronet
