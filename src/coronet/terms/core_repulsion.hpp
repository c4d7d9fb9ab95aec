// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cores: particles nearer than a range a repel each other with the energy
//     phi(r) = s a/2 (1 - r/a)^2,   force s (1/r - 1/a) x_ij on i,
// along the pair, so linear and angular momentum are conserved, and so is energy. A smooth flow cannot bring particles
// together, but what a smoothed divergence does not see can, and nothing else parts them again. With s = 2 sigma a^(D-2)
// a complete overlap costs sigma a^(D-1), the energy of as much surface as a particle has: tension cannot
// press particles into each other, not even at a corner. (In the spirit of Tsuruta, Khayyer and Gotoh, Comput. Fluids
// 82 (2013) 158, whose force acts between particles that overlap, too, but is no derivative of an energy.)

#include "coronet/pairs/law.hpp"

namespace coronet {

struct CoreRepulsion {
    double range_in_spacings = 0;
    double range = 1;     ///< a [m]
    double strength = 0;  ///< s [N/m in 2D, N in 3D]

    using reads = Fields<>;
    using own = Fields<Mass>;
    using gives = Fields<Acceleration>;

    template <class Keys>
    void describe(Keys& keys) {
        keys.number({.path = "method.core_range",
                     .unit = "spacings",
                     .meaning = "particles nearer than that repel each other, as strongly as surface tension pulls; 0: "
                                "they do not",
                     .at_least = 0,
                     .at_most = 1},
                    range_in_spacings);
    }
    bool active() const { return range_in_spacings > 0; }

    /// For particles `spacing` [m] apart of a liquid of surface tension sigma [N/m] in `dimension` dimensions.
    void scale(double spacing, double sigma, int dimension) {
        range = (active() ? range_in_spacings : 1) * spacing;
        strength = 2 * sigma * (dimension == 3 ? range : 1);
    }

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const out = largest(inverse_root(ij.r2 + R(1e-12 * range * range)) - R(1 / range), R(0));
        return give<gives>(ij, (R(strength) * (1.0 / ij.i.m) * out) * ij.x);
    }
};

}  // namespace coronet
