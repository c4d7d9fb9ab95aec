// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How near the nearest neighbours of particles are.

#include <algorithm>
#include <cmath>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

/// The hundredth part of the particles have a neighbour nearer than that [m].
template <int D>
double nearest_neighbour_p01(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    auto const view = particles.view();
    std::vector<double> nearest(particles.owned(), neighbours.support());
    for_each(nearest.size(), [&](std::size_t i) {
        for (Index const j : neighbours.row(i)) {
            double const r = std::sqrt(
                norm2(view.template get<Position>(static_cast<std::size_t>(j)) - view.template get<Position>(i)));
            nearest[i] = std::min(nearest[i], r);
        }
    });
    auto const hundredth = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 100);
    std::nth_element(nearest.begin(), hundredth, nearest.end());
    return *hundredth;
}

/// A copy of the positions alone, which a listing of neighbours may re-order.
template <int D>
Particles<D> copy_of_positions(Particles<D> const& particles) {
    Particles<D> points(particles.owned());
    points.allocate(Fields<Position>{});
    for_each(points.owned(), [&](std::size_t i) {
        points.view().template set<Position>(i, particles.view().template get<Position>(i));
    });
    return points;
}

}  // namespace coronet
