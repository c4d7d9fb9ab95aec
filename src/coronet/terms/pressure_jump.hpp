// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sum from which the pressure around a point is averaged: over KernelSum, sum_j V_j (p_j - p_i) W_ij is how far the
// Shepard mean of the neighbours is above p_i. No mean is outside of what the neighbours have.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct PressureJumps {
    using reads = Fields<Volume, Pressure>;
    using own = Fields<>;
    using gives = Fields<PressureJump>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, (ij.j.V * ij.W) * (ij.j.p - ij.i.p));
    }
};

}  // namespace coronet
