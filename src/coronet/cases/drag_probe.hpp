// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The drag on a sphere of a cubic array in a periodic box, beside theory (sphere_array.hpp). A body force f drives
// liquid along x. Had a pressure drop driven it, the sphere would feel that drop, too, as a body of its volume:
//     K = (F_x + rho f V)/(6 pi mu a U),   V = 4 pi a^3/3,   U = sum m v_x/(rho L^3),
// F_x the force on the wall as it is measured; steady, F_x = f sum m.

#include "coronet/cases/probe.hpp"

namespace coronet {

class DragProbe final : public Probe<3> {
public:
    DragProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {"drag_coefficient", "drag_balance"}; }
    /// The drag coefficient K, and F_x over f sum m, which is 1 in a steady flow.
    std::vector<double> sample(Snapshot<3> const& now) override;
    std::vector<Measure> measures() const override;

private:
    std::size_t wall_;
    double radius_, force_, density_, viscosity_, cell_, exact_, fraction_;
    double drag_ = 0, balance_ = 0;
};

}  // namespace coronet
