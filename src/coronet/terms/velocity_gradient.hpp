// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sums from which velocity gradients are made. VelocitySlope, sum_j V_j (v_j - v_i) grad W_ij, is the plain SPH
// gradient itself (Fang et al. 2009, Eq 22); with VelocityJump and the correction of terms/gradient_correction.hpp it
// becomes the FPM gradient (Eq 38). Both vanish for a common translation.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct VelocitySlopes {
    using reads = Fields<Volume, Velocity>;
    using own = Fields<>;
    using gives = Fields<VelocitySlope>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, outer(ij.j.v - ij.i.v, (ij.j.V * ij.F) * ij.x));
    }
};

struct VelocityJumps {
    using reads = Fields<Volume, Velocity>;
    using own = Fields<>;
    using gives = Fields<VelocityJump>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, (ij.j.V * ij.W) * (ij.j.v - ij.i.v));
    }
};

}  // namespace coronet
