// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The shifting vector of Sun, Colagrossi, Marrone, Antuono and Zhang, Comput. Methods Appl. Mech. Eng. 348 (2019) 912
// (and Comput. Phys. Commun. 224 (2018) 63), after Lind et al., J. Comput. Phys. 231 (2012) 1499:
//     R_i = -H sum_j V_j (1 + 0.2 (W_ij/W(dx))^4) grad W_ij,
// down the slope of the particles' concentration, H the support (their 2h). The second term grows as particles come
// nearer than the spacing dx, where the slope of the kernel falls: it keeps pairs from forming. Dimensionless.
//
// At a free surface the concentration falls outwards, too: there the shift is held (schemes/shifting.hpp).

#include "coronet/pairs/law.hpp"

namespace coronet {

struct ConcentrationShift {
    static constexpr bool respects_surface = true;

    double support;       ///< H [m]
    double W_at_spacing;  ///< W(dx) [1/m^D]

    using reads = Fields<Volume>;
    using own = Fields<>;
    using gives = Fields<Crowding>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const W = R(1 / W_at_spacing) * ij.W;
        R const W2 = W * W;
        return give<gives>(ij, ((ij.j.V * ij.F) * (R(1) + R(0.2) * (W2 * W2))) * ij.x);
    }

    /// R of the sums.
    template <class R, int D, class List>
    CORONET_HD Vector<R, D> vector(Values<R, D, List> const& sums) const {
        return R(-support) * sums.crowding;
    }
};

}  // namespace coronet
