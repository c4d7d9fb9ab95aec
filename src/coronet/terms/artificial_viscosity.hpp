// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Artificial viscosity: a pressure between approaching particles that removes energy where the method would be
// unstable,
//     dv_i/dt = - sum_j m_j Pi_ij grad W_ij,
//     Pi_ij = (-alpha c_ij phi_ij + beta phi_ij^2)/rho_ij  if v_ij . x_ij < 0, else 0,
//     phi_ij = h v_ij . x_ij/(|x_ij|^2 + 0.01 h^2),
// Fang et al. (2009) Eqs 97-103 after Monaghan; c_ij and rho_ij are means. The gradient is the plain one: the force
// then points along the pair and conserves linear and angular momentum with any gradient elsewhere.

#include "coronet/pairs/law.hpp"

namespace coronet {

struct ArtificialViscosity {
    double alpha = 0;  ///< linear coefficient [-]
    double beta = -1;  ///< quadratic coefficient [-]; unset: twice alpha

    using reads = Fields<Volume, Velocity, Density, SoundSpeed>;
    using own = Fields<>;
    using gives = Fields<Acceleration>;

    template <class Keys>
    void describe(Keys& keys) {
        keys.number({.path = "method.artificial_viscosity",
                     .unit = "-",
                     .meaning = "linear coefficient alpha of Monaghan's artificial viscosity",
                     .at_least = 0},
                    alpha);
        if (beta < 0) beta = 2 * alpha;
        keys.number({.path = "method.artificial_viscosity_beta",
                     .unit = "-",
                     .meaning = "its quadratic coefficient beta; by default twice alpha",
                     .at_least = 0},
                    beta);
    }
    bool active() const { return alpha > 0 || beta > 0; }

    /// alpha adds a kinematic viscosity of up to alpha h c/8: the bound of Eq 92 for it, with its safe factor 1/8.
    double step_limit(double h, double c) const { return h / (alpha * c); }

    template <class P>
    CORONET_HD auto central(P const& ij) const {
        using R = typename P::Number;
        double const quadratic = beta > 0 ? beta : 0;  // unset it is below
        // phi = a/q, both in units of h, so that one division does for phi and for the density.
        R const per_h = 1.0 / ij.h;
        R const a = per_h * smallest(dot(ij.i.v - ij.j.v, ij.x), R(0));
        R const q = ij.r2 * (per_h * per_h) + R(0.01);
        R const minus_Pi = a * (R(alpha) * (ij.i.c + ij.j.c) * q - R(2 * quadratic) * a);  // times q^2 (rho_i + rho_j)
        return ij.j.rho * minus_Pi / (q * q * (ij.i.rho + ij.j.rho));
    }
};

}  // namespace coronet
