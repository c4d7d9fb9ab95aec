// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which particles belong together: those whose discs (balls) are joined, directly or through others.

#include <algorithm>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

/// The pieces' numbers, counted from 0 in the order of their first particles, and how many there are. `reach` [m] is
/// twice the radius of the discs.
template <int D>
std::size_t number_pieces(Particles<D> const& particles, Neighbours<D> const& neighbours, double reach,
                          std::vector<Index>& piece) {
    auto const view = particles.view();
    std::fill(piece.begin(), piece.end(), -1);
    std::size_t pieces = 0;
    std::vector<std::size_t> open;
    for (std::size_t first = 0; first < piece.size(); ++first) {
        if (piece[first] >= 0) continue;
        auto const number = static_cast<Index>(pieces++);
        piece[first] = number;
        open.push_back(first);
        while (!open.empty()) {
            std::size_t const i = open.back();
            open.pop_back();
            for (Index const at : neighbours.row(i)) {
                auto const x =
                    view.template get<Position>(static_cast<std::size_t>(at)) - view.template get<Position>(i);
                std::size_t const j = neighbours.images().original(particles, static_cast<std::size_t>(at));
                if (piece[j] >= 0 || norm2(x) > reach * reach) continue;
                piece[j] = number;
                open.push_back(j);
            }
        }
    }
    return pieces;
}

}  // namespace coronet
