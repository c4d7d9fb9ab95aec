// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A column of liquid, H high and W wide, that collapses along the floor from a wall at its left: how far its front has
// come from that wall, and the pressure at a sensor. Beside them
//   - for H = 2 W, the front that J. C. Martin and W. J. Moyce, Phil. Trans. R. Soc. A 244 (1952) 312, and S. Koshizuka
//     and Y. Oka, Nucl. Sci. Eng. 123 (1996) 421, measured, to t sqrt(2 g/H) = 2.5;
//   - for W = 2 H and a tank 5.366 H long, the pressure 0.01 H above the floor in the wall opposite: measured by L.
//     Lobovsky et al., J. Fluids Struct. 48 (2014) 407, and computed by J. J. De Courcy et al., Comput. Methods Appl.
//     Mech. Eng. 420 (2024) 116700, for a liquid without viscosity in two dimensions. What is compared is when
//     the front arrives, a pressure of 0.1 rho g H, and the mean from t sqrt(g/H) = 3.3 to 5.3, between the first impact
//     and what falls back.
// Times are from when the column is let go.

#include "coronet/cases/sensor_probe.hpp"
#include "coronet/cases/wall_fill.hpp"

namespace coronet {

/// A measured curve: a value over time, both in the units of its table.
struct Curve {
    std::vector<double> time, value;

    /// Linear between the points, as the ends beyond them.
    double at(double t) const;
    /// The mean over [from, to]; NaN where the curve does not reach that far.
    double mean(double from, double to) const;
    /// When it first exceeds a value; NaN where it never does.
    double first_above(double value) const;
};

/// A table of cases/reference by its name; empty where there is none.
Curve builtin_curve(std::string const& name);

class DamBreakProbe final : public Probe<2> {
public:
    DamBreakProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {"front", "sensor_pressure", "through_walls"}; }
    /// The front [m from the left wall], the pressure at the sensor [Pa], and how many particles are in the solid.
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;
    std::vector<Profile> profiles() const override;

private:
    Sensor<2> sensor_;
    Solid<2> solid_;
    double through_ = 0;
    double density_, gravity_, height_, width_, left_, half_spacing_;
    Curve front_, pressure_;  // over t sqrt(2 g/W), t sqrt(g/H); over W, rho g H
};

}  // namespace coronet
