// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A pressure sensor in the wall that a collapsing column, H high, runs into, in units of rho g H over t sqrt(g/H). For
// a column 2 H wide in a tank 5.366 H long there are, each for a sensor of its height above the floor and of its width,
//   - three of L. Lobovsky et al., J. Fluids Struct. 48 (2014) 407, measured, P1 at 0.01 H, P3 at 0.1 H and P4 at 0.267
//   H,
//   - the same computed by J. J. De Courcy et al., Comput. Methods Appl. Mech. Eng. 420 (2024) 116700, for a liquid
//   without
//     viscosity in two dimensions,
//   - B. Buchner, thesis, Delft (2002), measured with a disc as wide as 0.15 H at 0.267 H.
// What is compared is the mean from t sqrt(g/H) = 3.3 to 5.3, between the first impact and what falls back, and when P1
// feels the front, a pressure of 0.1 rho g H.

#include "coronet/cases/measured_curve.hpp"
#include "coronet/cases/sensor_probe.hpp"

namespace coronet {

class ImpactProbe final : public Probe<2> {
public:
    ImpactProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {name_}; }
    /// The pressure [Pa].
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;
    /// The pressure over rho g H at the measured times, t sqrt(g/H).
    std::vector<Profile> profiles() const override;

private:
    struct Reference {
        char const *table, *measure, *source;
        double above, wide;  ///< the sensor's centre above the floor and its width, over H
    };
    static std::vector<Reference> references_of(ProbeKeys const& keys, Case const& c, double height, double width);

    std::string name_;
    Sensor<2> sensor_;
    double unit_, rate_;  ///< rho g H [Pa], sqrt(g/H) [1/s]
    std::vector<Reference> references_;
    Curve pressure_;
};

}  // namespace coronet
