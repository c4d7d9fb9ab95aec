// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The equation of state of a weakly compressible liquid: pressure [Pa] from density [kg/m^3]. Both forms have sound
// speed c and zero pressure at the reference density rho0:
//   linear  p = c^2 (rho - rho0)                                 Fang et al. (2009) Eq 8
//   tait    p = rho0 c^2/gamma ((rho/rho0)^gamma - 1)            Monaghan, J. Comput. Phys. 110 (1994) 399

#include "coronet/core/real.hpp"

namespace coronet {

struct EquationOfState {
    enum class Kind { linear, tait } kind = Kind::linear;
    double rho0 = 1000;  ///< reference density [kg/m^3]
    double c = 10;       ///< sound speed at rho0 [m/s]
    double gamma = 7;    ///< exponent of the Tait form [-]

    CORONET_HD double pressure(double rho) const {
        if (kind == Kind::linear) return c * c * (rho - rho0);
        return rho0 * c * c / gamma * (std::pow(rho / rho0, gamma) - 1);
    }

    /// sqrt(dp/drho) [m/s]
    CORONET_HD double sound_speed(double rho) const {
        return kind == Kind::linear ? c : c * std::pow(rho / rho0, 0.5 * (gamma - 1));
    }

    /// The work of compression from rho0 [J/kg], the integral of p/rho^2 over rho.
    CORONET_HD double energy(double rho) const {
        double const less = rho0 / rho - 1;  // of the volume
        if (kind == Kind::linear) return c * c * (std::log1p((rho - rho0) / rho0) + less);
        double const work = gamma == 1 ? std::log(rho / rho0) : (std::pow(rho / rho0, gamma - 1) - 1) / (gamma - 1);
        return c * c / gamma * (work + less);
    }

    /// The density at which the pressure is p. In the Tait form p must exceed -rho0 c^2/gamma, where density vanishes.
    CORONET_HD double density(double p) const {
        if (kind == Kind::linear) return rho0 + p / (c * c);
        return rho0 * std::pow(1 + gamma * p / (rho0 * c * c), 1 / gamma);
    }
};

}  // namespace coronet
