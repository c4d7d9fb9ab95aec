// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Taylor and Green's vortices in a doubly periodic square of side L, an exact solution of the Navier-Stokes equations
// (Taylor and Green, Proc. R. Soc. A 158 (1937) 499, in 2D): with k = 2 pi/L and f = exp(-2 k^2 nu t),
//     u = -U f cos(k x) sin(k y),   v = U f sin(k x) cos(k y),   p = -(rho U^2 f^2/4) (cos(2 k x) + cos(2 k y)),
// so that the kinetic energy is f^2 = exp(-16 pi^2 nu t/L^2) of the initial one. Lengths in m, speeds in m/s.

#include "coronet/cases/probe.hpp"

namespace coronet {

class TaylorGreenProbe final : public Probe<2> {
public:
    TaylorGreenProbe(ProbeKeys const& keys, Case const& c);

    /// f.
    double decay(double time) const;
    Vector<double, 2> velocity(Vector<double, 2> const& x, double time) const;

    std::vector<std::string> columns() const override {
        return {"velocity_max", "energy_ratio", "exact_energy_ratio", "velocity_error"};
    }
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;

private:
    double k_, speed_, viscosity_;  // k, U and nu
    double first_energy_ = 0;
    double worst_decay_ = 0, worst_velocity_ = 0;  // until a tenth of the energy is left
};

}  // namespace coronet
