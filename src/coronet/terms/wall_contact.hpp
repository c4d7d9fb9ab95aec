// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Contact: what keeps liquid out of a wall where pressure does not. A particle alone, or one in tension, is not held off
// by the pressure of wall particles, and between them nothing would stop it. Nearer to one than d, half the diagonal of
// a square of the lattice, which leaves no gap between them,
//     dv_i/dt = c^2/d (1 - r/d) x_ij/r,
// c the sound speed of the liquid: half of c^2 is the energy per mass that it takes to reach a wall particle, and its
// frequency is that of sound across d. Liquid on a lattice is farther away, and feels nothing. Along x_ij, so that with
// the opposite force on the wall particle momentum and its moment are kept.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct WallContact {
    double range = 0;        ///< d [m]
    double sound_speed = 0;  ///< c [m/s]

    using reads = Fields<ToMirror>;
    using own = Fields<>;
    using gives = Fields<Acceleration>;

    /// c^2/d (1 - r/d)/r, 0 beyond d [1/s^2].
    template <class R>
    CORONET_HD R push(R const& r2) const {
        R const r = square_root(r2 + R(1e-12 * range * range));
        return largest(R(sound_speed * sound_speed / range) * (R(1) - r * R(1 / range)), R(0)) / r;
    }
    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const push_here = select(norm2(ij.j.to_mirror) > R(0), push(ij.r2), R(0));  // 0 for liquid
        return give<gives>(ij, push_here * ij.x);
    }
};

}  // namespace coronet
