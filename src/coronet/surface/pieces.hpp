// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which particles belong together: those whose discs (balls) are joined, directly or through others.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

/// The pieces' numbers, counted from 0 in the order of the least identity in each, and how many there are: while pieces
/// neither join nor part each keeps its number, however the particles are sorted. `reach` [m] is twice the radius of
/// the discs.
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
    std::vector<std::int64_t> least(pieces, std::numeric_limits<std::int64_t>::max());
    for (std::size_t i = 0; i < piece.size(); ++i) {
        auto& of_piece = least[static_cast<std::size_t>(piece[i])];
        of_piece = std::min(of_piece, particles.id[i]);
    }
    std::vector<std::size_t> order(pieces);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) { return least[k]; });
    std::vector<Index> number(pieces);
    for (std::size_t k = 0; k < pieces; ++k) number[order[k]] = static_cast<Index>(k);
    for (Index& k : piece) k = number[static_cast<std::size_t>(k)];
    return pieces;
}

}  // namespace coronet
