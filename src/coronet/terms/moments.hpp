// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The moments of the kernel over the neighbours of i: the entries of the small matrix of the finite particle method
// (Fang et al. 2009, Eqs 31 and 37). The neighbour sum lacks j = i, which adds V_i W(0) to KernelSum and nothing else.

#include "coronet/pairs/law.hpp"

namespace coronet {

/// Of order zero.
struct KernelSums {
    using reads = Fields<Volume>;
    using own = Fields<>;
    using gives = Fields<KernelSum, SlopeSum>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, ij.j.V * ij.W, (ij.j.V * ij.F) * ij.x);
    }
};

/// Of order one.
struct KernelMoments {
    using reads = Fields<Volume>;
    using own = Fields<>;
    using gives = Fields<KernelMoment, SlopeMoment>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        auto const VgradW = (ij.j.V * ij.F) * ij.x;
        return give<gives>(ij, -(ij.j.V * ij.W) * ij.x, -outer_of_parallels(VgradW, ij.x));
    }
};

using Moments = Sum<KernelSums, KernelMoments>;

}  // namespace coronet
