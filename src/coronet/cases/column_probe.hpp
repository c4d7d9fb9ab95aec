// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A column along the x axis, periodic in it, that surface tension breaks up: the wave a of r = R (1 + a cos(k x +
// phi)), k = 2 pi n/L, L the length of the periodic box. To first order in a the sum over particles of the volume
// m/rho0 times exp(i k x) I_0(k r) is pi R^2 L I_0(k R) a exp(-i phi), r from the axis through the centre of mass:
// I_0(k r) cos k x is harmonic, so only the form of the column counts and no surface need be found. R follows from the
// volume. The growth rate is fitted (growth_fit.hpp) from where a has doubled to where it is a tenth, beside that
// of theory (column_mode.hpp).
//
// The neck is the thinnest of slices as long as the reach of the surface's balls, 2 times the coverage radius, by their
// volume; a slice without any particle is where the column has broken.

#include <complex>

#include "coronet/cases/energy_ledger.hpp"

namespace coronet {

class ColumnProbe final : public Probe<3> {
public:
    ColumnProbe(ProbeKeys const& keys, Case const& c);
    std::vector<std::string> columns() const override;
    std::vector<double> sample(Snapshot<3> const& now) override;
    std::vector<Measure> measures() const override;

private:
    double amplitude_of(Particles<3> const& particles) const;
    double neck_of(Particles<3> const& particles) const;
    Measure growth_rate() const;

    Case const& case_;
    double length_, k_;                // of the box [m], of the wave [1/m]
    double radius_ = 0, density_ = 0;  // of the column at the start [m], [kg/m^3]
    EnergyLedger<3> ledger_;
    std::vector<double> time_, amplitude_;
    std::optional<double> broken_;  // since when [s]
    Vector<double, 3> momentum_;    // of the first sample
    double mass_ = 0, momentum_drift_ = 0;
};

}  // namespace coronet
