// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The moments of the kernel over the neighbours of i: the entries of the small matrix of the finite particle method
// (Fang et al. 2009, Eqs 31 and 37). The neighbour sum lacks j = i, which adds V_i W(0) to KernelSum and nothing else.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct Moments {
    using reads = Fields<Volume>;
    using own = Fields<>;
    using gives = Fields<KernelSum, KernelMoment, SlopeSum, SlopeMoment>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        auto const VW = ij.j.V * ij.W;
        auto const VgradW = (ij.j.V * ij.F) * ij.x;
        return give<gives>(ij, VW, -VW * ij.x, VgradW, -outer_of_parallels(VgradW, ij.x));
    }
};

}  // namespace coronet
