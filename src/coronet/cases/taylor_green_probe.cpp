// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/taylor_green_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

TaylorGreenProbe::TaylorGreenProbe(ProbeKeys const& keys, Case const& c)
    : k_(2 * std::numbers::pi / Formula(keys.side, c.parameters)(Vector<double, 2>{}, 0)),
      speed_(Formula(keys.speed, c.parameters)(Vector<double, 2>{}, 0)),
      viscosity_(c.fluid.viscosity / c.fluid.density) {}

double TaylorGreenProbe::decay(double time) const { return std::exp(-2 * k_ * k_ * viscosity_ * time); }

Vector<double, 2> TaylorGreenProbe::velocity(Vector<double, 2> const& x, double time) const {
    double const kx = k_ * x[0], ky = k_ * x[1], U = speed_ * decay(time);
    return {{-U * std::cos(kx) * std::sin(ky), U * std::sin(kx) * std::cos(ky)}};
}

std::vector<double> TaylorGreenProbe::sample(Snapshot<2> const& now) {
    auto const view = now.particles.view();
    std::size_t const n = now.particles.owned();
    double const energy = totals(now.particles).kinetic_energy;
    if (first_energy_ == 0) first_energy_ = energy;
    double const fastest = std::sqrt(max_over(n, 0, [&](std::size_t i) { return norm2(view.get<Velocity>(i)); }));
    double const squares = sum_over(n, 0.0, [&](std::size_t i) {
        return norm2(view.get<Velocity>(i) - velocity(view.get<Position>(i), now.time));
    });
    double const error = std::sqrt(squares / static_cast<double>(n)) / speed_;
    double const ratio = energy / first_energy_, exact = decay(now.time) * decay(now.time);
    if (exact >= 0.1) {
        worst_decay_ = std::max(worst_decay_, std::fabs(ratio - exact));
        worst_velocity_ = std::max(worst_velocity_, error);
    }
    return {fastest, ratio, exact, error};
}

std::vector<Measure> TaylorGreenProbe::measures() const {
    std::string const source = "exact solution, Taylor and Green (1937), until a tenth of the energy is left";
    return {{"decay_error", worst_decay_, 0.0, worst_decay_, source + "; largest, over the initial energy"},
            {"velocity_error_l2", worst_velocity_, 0.0, worst_velocity_, source + "; largest rms, over U"}};
}

}  // namespace coronet
