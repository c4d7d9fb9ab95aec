// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/hydrostatic_probe.hpp"

#include <cmath>

#include "coronet/cases/formula.hpp"
#include "coronet/cases/totals.hpp"

namespace coronet {

template <int D>
HydrostaticProbe<D>::HydrostaticProbe(ProbeKeys const& keys, Case const& c)
    : solid_(Solid<D>::at_rest(c)),
      density_(c.fluid.density),
      depth_(Formula(keys.depth, c.parameters)(Vector<double, D>{}, 0)) {
    for (int k = 0; k < D; ++k) up_[k] = -c.fluid.gravity[k];
    g_ = std::sqrt(norm2(up_));
    up_ = (1 / g_) * up_;
}

template <int D>
std::vector<double> HydrostaticProbe<D>::sample(Snapshot<D> const& now) {
    auto const& particles = now.particles;
    auto const view = particles.view();
    auto const total = totals(particles);
    double const height = dot(total.centre(), up_);
    if (!started_) {  // half of the depth is above the centre
        first_centre_ = height;
        first_surface_ = height + depth_ / 2;
        started_ = true;
    }
    sunk_ = (first_centre_ - height) / depth_;
    energy_ = total.kinetic_energy / (density_ * g_ * depth_ * total.volume);
    pressure_error_ = max_over(particles.owned(), 0, [&](std::size_t i) {
        double const below = first_surface_ - dot(view.template get<Position>(i), up_);
        return std::fabs(view.template get<Pressure>(i) / (density_ * g_ * depth_) - below / depth_);
    });
    through_ = sum_over(particles.owned(), 0.0,
                        [&](std::size_t i) { return solid_.holds(view.template get<Position>(i)) ? 1.0 : 0.0; });
    return {pressure_error_, energy_, sunk_, through_};
}

template <int D>
std::vector<Measure> HydrostaticProbe<D>::measures() const {
    return {{"pressure_error", pressure_error_, 0.0, pressure_error_, "largest, over rho0 g H: liquid at rest"},
            {"kinetic_energy_ratio", energy_, 0.0, energy_, "over rho0 g H times the volume: liquid at rest"},
            {"centre_sunk", sunk_, 0.0, sunk_, "over H: liquid at rest"},
            {"through_walls", through_, 0.0, through_, "no particle passes a wall"}};
}

template class HydrostaticProbe<2>;
template class HydrostaticProbe<3>;

}  // namespace coronet
