// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The continuity equation with the plain gradient, Fang et al. (2009) Eq 79:
//     drho_i/dt = rho_i sum_j V_j (v_i - v_j) . grad W_ij.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct Continuity {
    using reads = Fields<Volume, Velocity>;
    using own = Fields<Density>;
    using gives = Fields<DensityRate>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, ij.i.rho * (ij.j.V * ij.F * dot(ij.i.v - ij.j.v, ij.x)));
    }
};

}  // namespace coronet
