// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Viscosity along the line of two particles,
//     dv_i/dt = 1/rho_i sum_j V_j 2 (D + 2) mu_ij (v_ij . x_ij)/r^2 grad W_ij,
// after J. J. Monaghan and R. A. Gingold, J. Comput. Phys. 52 (1983) 374, with the coefficient of P. Espanol and M.
// Revenga, Phys. Rev. E 67 (2003) 026705: inside a liquid it is mu (lap v + 2 grad div v). At a free surface it
// dissipates as a stress does (A. Colagrossi et al., Phys. Rev. E 84 (2011) 026705), less what neighbours are missing
// there. Equal and opposite and along x_ij, it conserves momentum and angular momentum, and only takes energy.
//
// mu_ij is the harmonic mean of both viscosities, as in terms/morris_viscosity.hpp, and r^2 counts as 1e-4 h^2 at
// least.
//
// Of what a gradient of velocity does not see, particles that move against their neighbours in turn, a stress resists
// nothing. So a share of the viscosity may act in this way, the rest as stress.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct CentralViscosity {
    double share = 0;  ///< of the viscosity [-]; the rest is for the stress

    using reads = Fields<Volume, Velocity, Viscosity>;
    using own = Fields<Density>;
    using gives = Fields<Acceleration>;

    template <class Keys>
    void describe(Keys& keys) {
        keys.number({.path = "method.central_share",
                     .unit = "-",
                     .meaning = "of the viscosity, what acts along the line between particles instead of as stress: it "
                                "stops what gradients do not see",
                     .at_least = 0,
                     .at_most = 1},
                    share);
    }
    bool active() const { return share > 0; }

    template <class P>
    CORONET_HD auto central(P const& ij) const {
        using R = typename P::Number;
        constexpr int D = decltype(ij.x)::size;
        if (share == 0) return R(0);  // other terms do not wait for it
        R const rate = dot(ij.i.v - ij.j.v, ij.x) / largest(ij.r2, R(1e-4) * ij.h * ij.h);
        R const both = largest(ij.i.mu + ij.j.mu, R(1e-30));  // both may be none
        R const mu = ij.i.mu * ij.j.mu / (both * ij.i.rho);
        return R(4 * (D + 2) * share) * mu * rate;
    }
};

}  // namespace coronet
