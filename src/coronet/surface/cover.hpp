// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The question whether particle i is one of the free surface, put to a coverage of its circle or sphere
// (arc_coverage.hpp, sphere_coverage.hpp).

#include "coronet/neighbours/neighbours.hpp"
#include "coronet/surface/cap.hpp"

namespace coronet {

/// Fills `coverage` with the caps of the neighbours of i, and says whether they cover it. Neighbours are taken in
/// rings, the nearest first: they cover the most, and inside they are enough. If i is not covered, all caps are there.
/// `radius` is that of the circle of i, `others` of theirs, no larger.
template <int D, class Coverage>
bool cover(Coverage& coverage, Particles<D> const& particles, Neighbours<D> const& neighbours, std::size_t i,
           double radius, double others) {
    auto const view = particles.view();
    auto const x_i = view.template get<Position>(i);
    auto const add = [&](double from, double to) {  // at distances in units of twice the radius
        double const reach2 = 4 * radius * radius, from2 = from * std::fabs(from) * reach2, to2 = to * to * reach2;
        for (Index const j : neighbours.row(i)) {
            auto const x = view.template get<Position>(static_cast<std::size_t>(j)) - x_i;
            double const r2 = norm2(x);
            if (from2 < r2 && r2 <= to2) coverage.add(Cap<D>(x, radius, others), j);
        }
    };
    constexpr double near = 0.6;
    coverage.clear();
    add(-1, near);
    if (coverage.seems_covered()) return true;
    add(near, 1);
    return coverage.covered();
}

}  // namespace coronet
