// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drag_probe.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/sphere_array.hpp"
#include "coronet/cases/totals.hpp"
#include "coronet/cases/wall_force_probe.hpp"

namespace coronet {

using std::numbers::pi;

DragProbe::DragProbe(ProbeKeys const& keys, Case const& c)
    : wall_(wall_named(keys.wall, c)),
      radius_(Formula(keys.radius, c.parameters)(Vector<double, 3>{}, 0)),
      force_(Formula(c.fluid.body_force[0], c.parameters)(Vector<double, 3>{}, 0) + c.fluid.gravity[0]),
      density_(c.fluid.density),
      viscosity_(c.fluid.viscosity),
      cell_(c.domain.size[0] * c.domain.size[1] * c.domain.size[2]) {
    fraction_ = 4 * pi / 3 * std::pow(radius_, 3) / cell_;
    exact_ = sphere_array_drag(fraction_);
}

std::vector<double> DragProbe::sample(Snapshot<3> const& now) {
    auto const total = totals(now.particles);
    double const on_wall = wall_load(now.particles, wall_, Vector<double, 3>{}).force[0];
    double const U = total.momentum[0] / (density_ * cell_);
    balance_ = on_wall / (force_ * total.mass);
    drag_ = U > 0 ? (on_wall + density_ * force_ * fraction_ * cell_) / (6 * pi * viscosity_ * radius_ * U) : 0;
    return {drag_, balance_};
}

std::vector<Measure> DragProbe::measures() const {
    auto const source =
        fmt::format("Sangani and Acrivos (1982), Zick and Homsy (1982), volume fraction {:.4g}", fraction_);
    return {
        {"drag_coefficient", drag_, exact_, drag_ - exact_, source},
        {"drag_error", drag_ / exact_ - 1, 0.0, drag_ / exact_ - 1, "relative, of the drag coefficient"},
        {"drag_balance", balance_, 1.0, balance_ - 1, "force on the wall over that on the liquid, in a steady flow"}};
}

}  // namespace coronet
