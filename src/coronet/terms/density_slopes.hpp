// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sums from which the gradient of density is made: DensitySlope, sum_j V_j (rho_j - rho_i) grad W_ij, is the plain
// SPH gradient (Fang et al. 2009, Eq 18); with DensityJump and the correction of terms/gradient_correction.hpp it is
// exact where density is linear. Units: kg/m^4 and kg/m^3.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct DensitySlopes {
    using reads = Fields<Volume, Density>;
    using own = Fields<>;
    using gives = Fields<DensitySlope, DensityJump>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const difference = ij.j.rho - ij.i.rho;
        return give<gives>(ij, (ij.j.V * ij.F * difference) * ij.x, (ij.j.V * ij.W) * difference);
    }
};

}  // namespace coronet
