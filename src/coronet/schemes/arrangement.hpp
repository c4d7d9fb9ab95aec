// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How the particles stand to each other, from lists of their neighbours that are up to date.

#include <algorithm>
#include <cmath>
#include <limits>

#include "coronet/neighbours/neighbours.hpp"
#include "coronet/schemes/scheme.hpp"

namespace coronet {

template <int D>
Arrangement arrangement_of(Particles<D> const& particles, Neighbours<D> const& neighbours) {
    auto const view = particles.view();
    double const H2 = neighbours.support() * neighbours.support();
    struct Seen {
        double pairs = 0, nearest2 = std::numeric_limits<double>::infinity();
    };
    auto const seen = fold(
        particles.owned(), Seen{},
        [&](std::size_t i) {
            Seen row;
            auto const x = view.template get<Position>(i);
            for (Index const j : neighbours.row(i)) {
                double const r2 = norm2(x - view.template get<Position>(static_cast<std::size_t>(j)));
                row.pairs += r2 < H2;
                row.nearest2 = std::min(row.nearest2, r2);
            }
            return row;
        },
        [](Seen const& a, Seen const& b) {
            return Seen{a.pairs + b.pairs, std::min(a.nearest2, b.nearest2)};
        });
    return {seen.pairs / static_cast<double>(particles.owned()), std::sqrt(seen.nearest2)};
}

}  // namespace coronet
