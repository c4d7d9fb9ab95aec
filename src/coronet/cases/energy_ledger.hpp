// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where the energy of a drop is, and whether any is made or lost. Of a liquid on whose boundary tension acts the series
// has
//     kinetic_energy       sum m v^2/2
//     surface_energy       sigma times the size of the boundary that acts (surface/boundary.hpp)
//     compressive_energy   sum m e(rho), the work of compression (materials/equation_of_state.hpp); none by projection
//     dissipated_energy    what viscous and artificial forces have taken: the work of all forces between particles
//                          less that of pressure, which is told by continuity, dual to it
//     tension_work         that of the force of tension
// and `energy_drift`, by how much the first four together have changed. It would be 0 but for steps in time, shifting,
// particles that join or leave the surface, and by projection the divergence that is left. Both it and the difference
// between the work of tension and the loss of surface energy are compared with the energy that was exchanged: the most
// that kinetic or surface energy have changed.

#include <optional>

#include "coronet/cases/probe.hpp"

namespace coronet {

template <int D>
class EnergyLedger {
public:
    /// Whether the case has one: tension on the boundary.
    static bool is_kept(Case const& c);

    explicit EnergyLedger(Case const& c) : is_kept_(is_kept(c)), is_free_(no_outer_force(c)) {}

    void add_columns(std::vector<std::string>& columns) const {
        if (is_kept_) columns.push_back("energy_drift");
    }
    void sample(Snapshot<D> const& now, std::vector<double>& row);
    void add_measures(std::vector<Measure>& measures) const;

private:
    struct Energies {
        double kinetic, surface, total;
    };

    bool is_kept_, is_free_;
    std::optional<Energies> start_;
    double drift_ = 0, tension_error_ = 0, exchanged_ = 0;  // the largest of all samples [J]
};

}  // namespace coronet
