// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A column of liquid, H high and W wide, that collapses along the floor from a wall at its left: how far its front has
// come from that wall, the liquid that is farthest within H/10 above the floor: spray above it counts for nothing.
// Beside it, to t sqrt(2 g/H) = 2.5, the front that was measured in a column of that form:
//   - H = 2 W: J. C. Martin and W. J. Moyce, Phil. Trans. R. Soc. A 244 (1952) 312, and S. Koshizuka and Y. Oka,
//     Nucl. Sci. Eng. 123 (1996) 421;
//   - H = W: Martin and Moyce, and L. Lobovsky et al., J. Fluids Struct. 48 (2014) 407;
//   - H = W/2: Lobovsky et al.
// Times are from when the column is let go. Lobovsky et al. count from when their gate begins to move; where an
// experiment does not say from when it counts, only a front whose times may all be late by one number can be judged.
// Each comparison therefore has three measures: the difference as it stands, the lateness that fits best, and the
// difference with it.

#include "coronet/cases/measured_curve.hpp"
#include "coronet/cases/probe.hpp"
#include "coronet/cases/wall_fill.hpp"

namespace coronet {

class DamBreakProbe final : public Probe<2> {
public:
    DamBreakProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {"front", "through_walls"}; }
    /// The front [m from the left wall], and how many particles are in the walls at rest.
    std::vector<double> sample(Snapshot<2> const& now) override;
    std::vector<Measure> measures() const override;
    /// The front over W at the measured times, t sqrt(2 g/W).
    std::vector<Profile> profiles() const override;

private:
    Solid<2> solid_;  // of the walls at rest
    double through_ = 0;
    double gravity_, height_, width_;
    Vector<double, 2> corner_;
    double half_spacing_;
    Curve front_;  // over W, over t sqrt(2 g/W)
};

/// The lower left corner of what the shapes of a case fill, that of the column [m].
Vector<double, 2> lower_corner(Case const& c);

}  // namespace coronet
