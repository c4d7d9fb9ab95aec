// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/neighbours/neighbours.hpp"

#include <algorithm>
#include <limits>

#include "coronet/core/simd.hpp"

namespace coronet {

namespace {

constexpr std::size_t particles_per_chunk = 256;
constexpr std::size_t pairs_per_block = 16384;

/// Appends to `row`, which has room, those of [range.first, range.last) within `reach` of x, except `self`.
template <int D>
Index* append_near(View<D> const& view, Range range, Vector<double, D> const& x, double reach, Index self, Index* row) {
    for (Index j = range.first; j < range.last; j += pack_size) {
        Pack<double> r2 = 0.0;
        for (int k = 0; k < D; ++k) {
            Pack<double> const d = load(view.template at<Position>(k) + j) - x[k];
            r2 += d * d;
        }
        unsigned held = lanes_below(r2, reach * reach);
        if (range.last - j < pack_size) held &= (1u << (range.last - j)) - 1;
        if (j <= self && self < j + pack_size) held &= ~(1u << (self - j));
        squeeze_range(held, j, row);
        row += __builtin_popcount(held);
    }
    return row;
}

}  // namespace

template <int D>
bool Neighbours<D>::update(Particles<D>& particles) {
    if (still_valid(particles)) return false;
    list(particles);
    ++listings_;
    return true;
}

template <int D>
bool Neighbours<D>::still_valid(Particles<D> const& particles) const {
    if (count_.size() != particles.size() || listings_ == 0) return false;
    std::size_t const n = particles.size();
    auto const view = particles.view();
    auto const moved = [&](std::size_t i) {
        return view.template get<Position>(i) - view.template get<PositionListed>(i);
    };
    auto const mean = (1.0 / static_cast<double>(n)) * sum_over(n, Vector<double, D>{}, moved);
    double const farthest2 = max_over(n, 0.0, [&](std::size_t i) {
        double const d2 = norm2(moved(i) - mean);
        return d2 == d2 ? d2 : std::numeric_limits<double>::infinity();
    });
    return 4 * farthest2 < skin_ * skin_;
}

template <int D>
void Neighbours<D>::list(Particles<D>& particles) {
    particles.allocate(Fields<PositionListed>{});
    double const reach = support_ + skin_;
    grid_.sort(particles, reach);

    std::size_t const n = particles.size();
    auto const view = particles.view();
    first_.resize(n);
    count_.resize(n);
    chunks_.resize((n + particles_per_chunk - 1) / particles_per_chunk);
    for_blocks(chunks_.size(), [&](std::size_t c) {
        auto& chunk = chunks_[c];
        std::size_t const begin = c * particles_per_chunk, end = std::min(n, begin + particles_per_chunk);
        std::size_t used = 0;
        for (std::size_t i = begin; i < end; ++i) {
            auto const x = view.template get<Position>(i);
            view.template set<PositionListed>(i, x);
            std::size_t const start = used;
            grid_.for_rows_around(x, [&](Range range) {
                std::size_t const room = used + static_cast<std::size_t>(range.last - range.first) + pack_size;
                if (chunk.size() < room) chunk.resize(room + room / 4);
                Index* const end_of_row =
                    append_near(view, range, x, reach, static_cast<Index>(i), chunk.data() + used);
                used = static_cast<std::size_t>(end_of_row - chunk.data());
            });
            count_[i] = static_cast<Index>(used - start);
        }
        // A sweep reads whole packs of a row: keep one more readable behind the last.
        chunk.resize(used + pack_size);
        std::fill(chunk.begin() + static_cast<std::ptrdiff_t>(used), chunk.end(), Index{0});
        Index const* row = chunk.data();
        for (std::size_t i = begin; i < end; row += count_[i], ++i) first_[i] = row;
    });

    longest_ = 0;
    for (Index count : count_) longest_ = std::max(longest_, static_cast<std::size_t>(count));
    all_ = {};
    cut(all_, n);
}

template <int D>
void Neighbours<D>::cut(Targets& targets, std::size_t count) const {
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < count; ++k) {
        pairs += static_cast<std::size_t>(count_[targets[k]]) + 1;
        if (pairs >= pairs_per_block || k + 1 == count) {
            targets.begin.push_back(k + 1);
            pairs = 0;
        }
    }
}

template class Neighbours<1>;
template class Neighbours<2>;
template class Neighbours<3>;

}  // namespace coronet
