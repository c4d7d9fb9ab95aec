// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sums over all particles: what is conserved, and what a run reports of itself at every sample.

#include <cmath>

#include "coronet/fields/particles.hpp"

namespace coronet {

template <int D>
struct Totals {
    double mass = 0, volume = 0, kinetic_energy = 0;  ///< kg, m^D, J
    Vector<double, D> momentum;                       ///< kg m/s
    Vector<double, 3> angular_momentum;               ///< about x = 0 [kg m^2/s]; in 2D only the third
    Vector<double, D> mass_moment;                    ///< kg m
    double momentum_scale = 0;                        ///< sum m |v|: what round-off of the momentum is measured by

    Vector<double, D> centre() const { return (1 / mass) * mass_moment; }
};

template <int D>
Totals<D> operator+(Totals<D> a, Totals<D> const& b) {
    a.mass += b.mass;
    a.volume += b.volume;
    a.kinetic_energy += b.kinetic_energy;
    a.momentum += b.momentum;
    a.angular_momentum += b.angular_momentum;
    a.mass_moment += b.mass_moment;
    a.momentum_scale += b.momentum_scale;
    return a;
}

template <int D>
Totals<D> totals(Particles<D> const& particles) {
    auto const view = particles.view();
    return sum_over(particles.owned(), Totals<D>{}, [&](std::size_t i) {
        double const m = view.template get<Mass>(i);
        auto const x = view.template get<Position>(i);
        auto const v = view.template get<Velocity>(i);
        Totals<D> one{
            m, m / view.template get<Density>(i), 0.5 * m * norm2(v), m * v, {}, m * x, m * std::sqrt(norm2(v))};
        one.angular_momentum[2] = m * (x[0] * v[1] - x[1] * v[0]);
        if constexpr (D == 3) {
            one.angular_momentum[0] = m * (x[1] * v[2] - x[2] * v[1]);
            one.angular_momentum[1] = m * (x[2] * v[0] - x[0] * v[2]);
        }
        return one;
    });
}

}  // namespace coronet
