// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the continuity equation lacks at a wall without slip. Viscosity must see the liquid go on behind the wall
// against its own direction, v = 2 v_wall - v'; the density must not, for there is no flow through such a place to
// compress anything: it sees liquid that slips along the wall (Marrone et al., J. Comput. Phys. 245 (2013) 456,
// section 2.3). The two velocities differ by u = 2 (v - v_wall) along the wall, so that
//     drho_i/dt += rho_i sum_j V_j u_j . grad W_ij   over wall particles.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct WallContinuity {
    using reads = Fields<Volume, Velocity, WallVelocity, ToMirror, Slip>;
    using own = Fields<Density>;
    using gives = Fields<DensityRate>;

    template <class P>
    CORONET_HD auto operator()(P const& ij) const {
        using R = typename P::Number;
        R const m2 = norm2(ij.j.to_mirror);  // 0 for liquid
        auto const from_wall = ij.j.v - ij.j.v_wall;
        R const across = dot(from_wall, ij.j.to_mirror) / select(m2 > R(0), m2, R(1));
        R const twice = select(m2 > R(0), R(2) - R(2) * ij.j.slip, R(0));
        return give<gives>(
            ij, (twice * ij.i.rho * (ij.j.V * ij.F)) * (dot(from_wall, ij.x) - across * dot(ij.j.to_mirror, ij.x)));
    }
};

}  // namespace coronet
