// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How many pieces the liquid is in: connected groups of particles, two being linked if they are within a radius.

#include <numeric>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

template <int D>
int fragments(Particles<D> const& particles, double radius) {
    std::size_t const n = particles.owned();
    Particles<D> points(n);
    points.allocate(Fields<Position>{});
    for (std::size_t i = 0; i < n; ++i)
        points.view().template set<Position>(i, particles.view().template get<Position>(i));
    Neighbours<D> linked(radius, 0);
    linked.update(points);

    std::vector<std::size_t> parent(n);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    auto const root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    int groups = static_cast<int>(n);
    for (std::size_t i = 0; i < n; ++i)
        for (Index const j : linked.row(i)) {
            std::size_t const a = root(i), b = root(static_cast<std::size_t>(j));
            if (a == b) continue;
            parent[a] = b;
            --groups;
        }
    return groups;
}

}  // namespace coronet
