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
    using gives = Fields<KernelMoment>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, -(ij.j.V * ij.W) * ij.x);
    }
};
struct SlopeMoments {
    using reads = Fields<Volume>;
    using own = Fields<>;
    using gives = Fields<SlopeMoment>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        return give<gives>(ij, -outer_of_parallels((ij.j.V * ij.F) * ij.x, ij.x));
    }
};

using Moments = Sum<KernelSums, KernelMoments, SlopeMoments>;

}  // namespace coronet
