// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Liquid at rest in a tank under gravity g, H deep: its pressure beside rho0 g times the depth below the initial
// surface, its kinetic energy over that of gravity, rho0 g H times its volume, how far its centre of mass has sunk or
// risen, over H, and how many particles are in the solid of a wall.

#include "coronet/cases/probe.hpp"
#include "coronet/cases/wall_fill.hpp"

namespace coronet {

template <int D>
class HydrostaticProbe final : public Probe<D> {
public:
    HydrostaticProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override {
        return {"pressure_error", "kinetic_energy_ratio", "centre_sunk", "through_walls"};
    }
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;

private:
    Solid<D> solid_;
    double density_, depth_, g_;
    Vector<double, D> up_;
    double first_centre_ = 0, first_surface_ = 0;
    bool started_ = false;
    double pressure_error_ = 0, energy_ = 0, sunk_ = 0, through_ = 0;
};

}  // namespace coronet
