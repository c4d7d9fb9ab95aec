// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Exact flow between two parallel plates at y = -L/2 and L/2 that slide along x, under a force per mass f along x.
// Steady: the stress is tau(y) = tau_0 - rho f y, and u follows from the liquid's law, du/dy = g(tau), by quadrature,
// with tau_0 such that u fits both plates; a yield stress counts in full, without the regularisation of the
// computation. From rest, for a Newtonian liquid of kinematic viscosity nu, with s = y + L/2,
//     u(s, t) = u_steady - sum_n b_n sin(n pi s/L) exp(-n^2 pi^2 nu t/L^2),
// b_n the sine coefficients of u_steady (Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214, Eqs 34 and 36).

#include <vector>

#include "coronet/materials/rheology.hpp"

namespace coronet {

class ChannelFlow {
public:
    struct Plates {
        double gap;           ///< L [m]
        double lower, upper;  ///< velocities [m/s]
    };
    ChannelFlow(Rheology const& law, double density, double force_per_mass, Plates const& plates);

    double steady(double y) const;
    /// From rest at t = 0, of a Newtonian liquid.
    double from_rest(double y, double t) const;

private:
    double rate(double stress) const;
    double profile(double stress_at_centre);

    Rheology law_;
    double density_, force_;
    Plates plates_;
    std::vector<double> u_;  // at the ends of equal cells from plate to plate
};

}  // namespace coronet
