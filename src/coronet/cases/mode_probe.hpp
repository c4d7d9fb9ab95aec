// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One mode of the shape of a drop in 2D, r = R (1 + a cos(n (theta - theta0))), by projection of the outline moved out
// by half a spacing (drop_outline.hpp) about its centroid; R from mass and density. The amplitude is a complex number,
// a exp(-i n theta0); it is shown along its first value, so that what oscillates is `mode_amplitude`, and what turns or
// is noise is `mode_amplitude_imaginary`. Period and damping rate come from a fit to the former (oscillation_fit.hpp),
// from one period of theory on, when sound and the first disorder are gone, to the end. Where viscosity depends on the
// shear rate, theory is given the one that dissipates: its mean over particles and samples, weighted by shear rate
// squared.

#include <complex>

#include "coronet/cases/drop_mode.hpp"
#include "coronet/cases/probe.hpp"

namespace coronet {

class ModeProbe final : public Probe<2> {
public:
    ModeProbe(ProbeKeys const& keys, Case const& c) : case_(c), n_(keys.mode) {}
    std::vector<std::string> columns() const override { return {"mode_amplitude", "mode_amplitude_imaginary"}; }
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;

private:
    struct Shear {
        double viscous = 0, squared = 0;
    };
    Shear shear_of(Particles<2> const& particles) const;
    double viscosity_of_the_flow(double from) const;

    Case const& case_;
    int n_;
    double radius_ = 0;                 // [m]
    std::complex<double> phase_ = 1;    // of the first amplitude
    std::vector<double> time_, value_;  // of all samples,
    std::vector<Shear> shear_;          // too
};

}  // namespace coronet
