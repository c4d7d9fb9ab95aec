// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force of the pressure alone with the plain gradient, the case sigma = -p I of Fang et al. (2009) Eq 80:
//     dv_i/dt = -1/rho_i sum_j V_j (p_i + p_j) grad W_ij.
// Equal and opposite, along the line of the pair: momentum and angular momentum are conserved to round-off.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct PressureGradient {
    using reads = Fields<Volume, Pressure>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class P>
    CORONET_HD auto central(P const& ij) const {
        return -1.0 / ij.i.rho * (ij.i.p + ij.j.p);
    }
};

}  // namespace coronet
