// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The plain SPH gradient of density, sum_j V_j (rho_j - rho_i) grad W_ij (Fang et al. 2009, Eq 18): with the inverse of
// the slope moments (terms/moments.hpp) it is exact where density is linear. Units: kg/m^4.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct DensitySlopes {
    using reads = Fields<Volume, Density>;
    using own = Fields<>;
    using gives = Fields<DensitySlope>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, (ij.j.V * ij.F * (ij.j.rho - ij.i.rho)) * ij.x);
    }
};

}  // namespace coronet
