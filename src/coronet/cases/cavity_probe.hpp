// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The lid-driven cavity, a square or cube from 0 to L whose face y = L slides along x with the speed U: u/U on the
// vertical midline and v/U on the horizontal one, over the coordinate over L, beside tabulated solutions of the
// Navier-Stokes equations at Reynolds numbers U L/nu of 100, 400 and 1000: in 3D at 1000 the spectral one of
// Albensoeder and Kuhlmann (2005), else those of cases/reference/cavity2d_own_reference.csv and
// cavity3d_own_reference.csv.

#include "coronet/cases/probe.hpp"
#include "coronet/kernels/kernel.hpp"

namespace coronet {

/// The name of the table in cases/reference.
std::string cavity_table(int dimension, double reynolds);

/// "u" and "v" without computed values; without any stations where the Reynolds number has no table.
std::vector<Profile> cavity_reference(int dimension, double reynolds);

template <int D>
class CavityProbe final : public Probe<D> {
public:
    CavityProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {"u_error", "v_error"}; }
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;
    std::vector<Profile> profiles() const override { return profiles_; }

private:
    double error(Profile const& profile) const;

    double length_, speed_;
    Kernel kernel_;
    double reynolds_;
    std::vector<Profile> profiles_;
};

}  // namespace coronet
