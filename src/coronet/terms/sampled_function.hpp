// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sums from which a sampled function and its gradient are interpolated: Fang et al. (2009) Eqs 17 and 18, and what
// the finite particle method needs beside its moments. The neighbour sum lacks j = i, which adds V_i f_i W(0) to
// SampleSum.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct SampledFunction {
    using reads = Fields<Volume, Sample>;
    using own = Fields<>;
    using gives = Fields<SampleSum, SampleJump, SampleSlope>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        auto const jump = ij.j.V * (ij.j.f - ij.i.f);
        return give<gives>(ij, ij.j.V * ij.j.f * ij.W, jump * ij.W, jump * ij.gradW);
    }
};

}  // namespace coronet
