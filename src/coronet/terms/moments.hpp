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
        auto const V = ij.j.V;
        Symmetric<typename P::Number, P::dimension> slope_moment;  // grad W is along x: the matrix is symmetric
        for (int a = 0; a < P::dimension; ++a)
            for (int b = a; b < P::dimension; ++b) slope_moment(a, b) = -V * ij.gradW[a] * ij.x[b];
        return give<gives>(ij, V * ij.W, -(V * ij.W) * ij.x, V * ij.gradW, slope_moment);
    }
};

}  // namespace coronet
