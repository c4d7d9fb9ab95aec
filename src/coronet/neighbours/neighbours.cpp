// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coronet/core/coordinate.hpp"
#include "coronet/core/simd.hpp"

namespace coronet {

namespace {

// A block is long enough that handing it to a thread costs nothing, and short enough that many fill all threads evenly.
constexpr std::size_t pairs_per_block = 4096;

// Of the support: a skin narrower than that gains nothing.
constexpr double narrowest_skin = 0.005;

/// A skin that makes rows 15 % longer is the widest: rows are most of the memory, and few flows want a wider one.
template <int D>
double widest_skin() {
    return std::pow(1.15, 1.0 / D) - 1;
}

/// Coordinates of all particles as differences between neighbours want them, and how far is near.
template <int D>
struct Scan {
    float const* x[D];
    float reach2;  ///< in units of the coordinates

    /// Appends to `row`, which has room, the places of those of [range.first, range.last) near i, except i.
    Index* append_near(Range range, Index i, Index* row) const {
        Pack<float> x_i[D];
        for (int k = 0; k < D; ++k) x_i[k] = Pack<float>::copies(x[k][i]);
        for (Index j = range.first; j < range.last; j += pack_size<float>) {
            Pack<float> r2 = 0.0;
            for (int k = 0; k < D; ++k) {
                Pack<float> const d = Coordinate<float>::steps(load(x[k] + j), x_i[k]);
                r2 += d * d;
            }
            unsigned held = lanes_below(r2, reach2);
            if (range.last - j < pack_size<float>) held &= (1u << (range.last - j)) - 1;
            if (j <= i && i < j + pack_size<float>) held &= ~(1u << (i - j));
            squeeze_range<float, Neighbours<D>::place>(held, Neighbours<D>::place * j, row);
            row += __builtin_popcount(held);
        }
        return row;
    }
};

}  // namespace

template <int D>
bool Neighbours<D>::update(Particles<D>& particles) {
    // Looking twice at the same positions is no motion: how often someone looks must not steer the skin.
    double const before = spread_;
    images_.refresh(particles, Fields<Position>{});
    bool const valid = still_valid(particles);
    updates_ += spread_ != before;
    if (valid) return false;
    if (listing_cost_ > 0 && listings_ > 0) tune();
    list(particles);
    ++listings_;
    updates_ = 0;
    still_valid(particles);  // the spread that rounding leaves without any motion
    return true;
}

template <int D>
auto Neighbours<D>::none() -> Displacements {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Displacements nothing;
    unrolled<D>([&](int k) { nothing.least[k] = infinity, nothing.most[k] = -infinity; });
    return nothing;
}

template <int D>
void Neighbours<D>::Displacements::add(Displacements const& others) {
    unrolled<D>([&](int k) {
        least[k] = std::min(least[k], others.least[k]);
        most[k] = std::max(most[k], others.most[k]);
    });
}

template <int D>
double Neighbours<D>::Displacements::spread() const {
    return least[0] <= most[0] ? std::sqrt(norm2(most - least)) : 0;
}

template <int D>
bool Neighbours<D>::still_valid(Particles<D> const& particles) {
    if (listed_[0].size() != particles.size() || listings_ == 0) return false;
    auto const view = particles.view();
    auto const blocks = grid_.pairs_of_cells();
    auto const place_of = [&](std::size_t b) {
        auto const along = static_cast<std::size_t>(blocks[0]), across = static_cast<std::size_t>(blocks[1]);
        return std::array<int, 3>{static_cast<int>(b % along), static_cast<int>(b / along % across),
                                  static_cast<int>(b / along / across)};
    };
    std::size_t const count = static_cast<std::size_t>(blocks[0]) * blocks[1] * blocks[2];
    displaced_.resize(count);
    constexpr std::size_t at_once = 16;
    auto const for_all = [&](auto const& act) {
        for_blocks((count + at_once - 1) / at_once, [&](std::size_t some) {
            for (std::size_t b = some * at_once; b < std::min(count, (some + 1) * at_once); ++b) act(b, some);
        });
    };

    for_all([&](std::size_t b, std::size_t) {
        Displacements here = none();
        grid_.for_rows_of_block(place_of(b), [&](Range range) {
            for (auto i = static_cast<std::size_t>(range.first); i < static_cast<std::size_t>(range.last); ++i) {
                Vector<double, D> moved = view.template get<Position>(i) - grid_.low();
                unrolled<D>([&](int k) { moved[k] -= listed_[k][i]; });
                here.add({moved, moved});
                // A position that is no number any more must not go unseen: listing anew will say so.
                if (!(norm2(moved) < std::numeric_limits<double>::infinity()))
                    here.most[0] = INFINITY, here.least[0] = 0;
            }
        });
        displaced_[b] = here;
    });

    std::vector<double> widest((count + at_once - 1) / at_once, 0.0);
    std::vector<Displacements> all(widest.size(), none());
    for_all([&](std::size_t b, std::size_t some) {
        auto const at = place_of(b);
        Displacements around = none();
        for (int c2 = std::max(at[2] - 1, 0); c2 <= std::min(at[2] + 1, blocks[2] - 1); ++c2)
            for (int c1 = std::max(at[1] - 1, 0); c1 <= std::min(at[1] + 1, blocks[1] - 1); ++c1)
                for (int c0 = std::max(at[0] - 1, 0); c0 <= std::min(at[0] + 1, blocks[0] - 1); ++c0)
                    around.add(displaced_[(static_cast<std::size_t>(c2) * blocks[1] + c1) * blocks[0] + c0]);
        widest[some] = std::max(widest[some], around.spread());
        all[some].add(displaced_[b]);
    });
    spread_ = *std::max_element(widest.begin(), widest.end());
    Displacements whole = none();
    for (Displacements const& part : all) whole.add(part);
    return spread_ + rounding_ < skin_ && whole.spread() + rounding_ < support_ + 2 * skin_;
}

template <int D>
void Neighbours<D>::tune() {
    double const Lw = listing_cost_ * spread_ / static_cast<double>(updates_);
    double const b = (D - 1) * Lw;
    double const best = (std::sqrt(b * b + 4 * D * Lw * support_) - b) / (2 * D);
    if (best == best)
        skin_ = std::min(std::max(best, narrowest_skin * support_ + 2 * rounding_), widest_skin<D>() * support_);
}

template <int D>
void Neighbours<D>::list(Particles<D>& particles) {
    double const reach = support_ + skin_;
    for (auto& chunk : chunks_) chunk = {};  // the old rows are of no use: their memory is
    images_.remake(particles, reach);
    images_.follow(particles, grid_.sort(particles, reach));

    std::size_t const n = particles.size(), rows_end = particles.end(Role::mirror);
    auto const view = particles.view();

    // The unit makes coordinates repeat after 64 cells, so that nothing in the cells around is taken for near. Lists
    // may name a pair that is a few units too far, but never lack one. Where cells had to be made very wide, the unit
    // would be too coarse: then it is finer, and what was taken for near is looked at again.
    double const widest = 16 * reach;
    bool const look_again = grid_.width() > widest;
    double const unit = std::min(grid_.width(), widest) * 0x1p-26, limit = reach / unit * (1 + 0x1p-22) + 8;
    Coordinate<float> const coordinate(unit);
    std::size_t const stride = n + pack_size<float>;
    float* const coordinates = particles.template scratch<float>(D * stride);
    Scan<D> scan{{}, static_cast<float>(limit * limit)};
    for (int k = 0; k < D; ++k) {
        float* const to = coordinates + static_cast<std::size_t>(k) * stride;
        listed_[k].resize(n);
        scan.x[k] = to;
        for_each(n, [&](std::size_t i) {
            double const x = view.template at<Position>(k)[i] - grid_.low()[k];
            listed_[k][i] = static_cast<float>(x);
            to[i] = coordinate.stored(x);
        });
    }

    // Two displacements are each off by half a unit in the last place of a float along every axis.
    rounding_ = 0x1p-23 * std::sqrt(D) * grid_.extent();
    first_.resize(rows_end);
    count_.resize(rows_end);
    chunks_.resize((rows_end + particles_per_chunk - 1) / particles_per_chunk);
    for_blocks(chunks_.size(), [&](std::size_t c) {
        auto& chunk = chunks_[c];
        std::size_t const begin = c * particles_per_chunk, end = std::min(rows_end, begin + particles_per_chunk);
        thread_local std::vector<Index> rows;
        std::size_t used = 0;
        for (std::size_t i = begin; i < end; ++i) {
            std::size_t const start = used;
            auto const x = view.template get<Position>(i);
            Role const own = particles.role(i);
            auto const wanted = [&](Role role) {
                return own == Role::liquid ? role != Role::mirror : role == Role::liquid || role == Role::liquid_image;
            };
            grid_.for_rows_around(x, wanted, [&](Range range) {
                std::size_t const room = used + static_cast<std::size_t>(range.last - range.first) + pack_size<float>;
                if (rows.size() < room) rows.resize(room + room / 4);
                Index* const end_of_row = scan.append_near(range, static_cast<Index>(i), rows.data() + used);
                used = static_cast<std::size_t>(end_of_row - rows.data());
            });
            if (look_again) {
                auto const far = [&](Index at) {
                    return !(norm2(view.template get<Position>(static_cast<std::size_t>(at / place)) - x) <
                             reach * reach);
                };
                auto const first = rows.begin() + static_cast<std::ptrdiff_t>(start);
                auto const last = rows.begin() + static_cast<std::ptrdiff_t>(used);
                used = start + static_cast<std::size_t>(std::remove_if(first, last, far) - first);
            }
            count_[i] = static_cast<Index>(used - start);
        }
        // No more memory than the rows need, and a pack behind the last.
        chunk.reserve(used + pack_size<float>);
        chunk.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(used));
        chunk.resize(used + pack_size<float>, Index{0});
        Index row = 0;
        for (std::size_t i = begin; i < end; row += count_[i], ++i) first_[i] = row;
    });

    all_ = {};
    cut(all_, particles.owned());
    auto const all_of = [&](Role role) {
        return targets(particles.begin(role), particles.end(role), [](std::size_t) { return true; });
    };
    walls_ = all_of(Role::wall);
    mirrors_ = all_of(Role::mirror);
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
