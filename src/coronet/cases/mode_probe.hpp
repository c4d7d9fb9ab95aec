// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One mode of the shape of a drop. In 2D, r = R (1 + a cos(n (theta - theta0))), by projection of the line around it
// (drop_outline.hpp) about its centroid; R from the volume. The amplitude is a complex number,
// a exp(-i n theta0); it is shown along its first value, so that what oscillates is `mode_amplitude`, and what turns or
// is noise is `mode_amplitude_imaginary`. In 3D, r = R (1 + a P_n(cos theta)), theta from the x axis of the first
// shape: to first order in a the sum over particles of the volume m/rho0 times the solid harmonic r^n P_n
// (solid_harmonic.hpp) about the centre of mass is 4 pi/(2n + 1) R^(n+3) a, so no surface need be found. Period and
// damping rate come from a fit to the former (oscillation_fit.hpp), from one period of theory on, when sound and the
// first disorder are gone, to the end. Where viscosity depends on the shear rate, theory is given the one that
// dissipates: its mean over particles and samples, weighted by shear rate squared.

#include <complex>

#include "coronet/cases/drop_mode.hpp"
#include "coronet/cases/probe.hpp"

namespace coronet {

template <int D>
class ModeProbe final : public Probe<D> {
public:
    ModeProbe(ProbeKeys const& keys, Case const& c) : case_(c), n_(keys.mode) {}
    std::vector<std::string> columns() const override {
        if (D == 3) return {"mode_amplitude"};
        return {"mode_amplitude", "mode_amplitude_imaginary"};
    }
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;

private:
    struct Shear {
        double viscous = 0, squared = 0;
    };
    std::complex<double> amplitude_of(Snapshot<D> const& now) const;
    Shear shear_of(Particles<D> const& particles) const;
    double viscosity_of_the_flow(double from) const;

    Case const& case_;
    int n_;
    double radius_ = 0, density_ = 0;   // at the start [m], [kg/m^3]
    std::complex<double> phase_ = 1;    // of the first amplitude
    std::vector<double> time_, value_;  // of all samples,
    std::vector<Shear> shear_;          // too
};

}  // namespace coronet
