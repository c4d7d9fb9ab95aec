// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Neighbour lists kept over several steps: each particle's row names all others within support + skin. Until two
// particles can have come skin closer, a row still holds everything inside the support; then the rows are listed anew
// and the particles re-ordered along the cell grid. What counts is how much the displacements differ among particles
// that can meet: in a block of 2^D cells and those around it. Particles of other blocks were two cells or more apart,
// and may come closer by more than a support. So neither a common translation nor a smooth flow ages the lists much.
//
// A wide skin makes rows longer than need be, a narrow one has them listed often. With the skin s, a sweep costs as
// (1 + s/H)^D, and if displacements come to differ by w an update (in m), lists last s/w updates; so
//     cost(s) = (1 + s/H)^D (1 + L w/s),
// with L the cost of a listing over that of an evaluation, is least where D s^2 + (D - 1) L w s = L w H. A skin that is
// tuned follows this at every listing, with the w that it saw since the last; it depends on the motion alone, not on a
// clock, so results stay the same from run to run.
//
// Rows hold each pair twice (j in the row of i, i in the row of j): every particle gathers its own sums. Liquid has all
// others in its rows but mirrors, wall particles and mirrors have liquid alone; images have no rows.

#include <ranges>
#include <span>
#include <vector>

#include "coronet/neighbours/cell_grid.hpp"
#include "coronet/neighbours/images.hpp"

namespace coronet {

/// Particles whose sums are wanted, cut into blocks of about equal pair counts; the cut does not depend on the threads.
struct Targets {
    std::vector<Index> particles;       ///< empty: all of them, in order
    std::vector<std::size_t> begin{0};  ///< block b holds the targets begin[b] ... begin[b + 1] - 1

    std::size_t blocks() const { return begin.size() - 1; }
    std::size_t operator[](std::size_t k) const {
        return particles.empty() ? k : static_cast<std::size_t>(particles[k]);
    }
};

template <int D>
class Neighbours {
public:
    /// support and skin in m. With a listing_cost (in evaluations) above zero the skin is only the first one, and
    /// tuned.
    Neighbours(double support, double skin, double listing_cost = 0, PeriodicBox<D> const& box = {})
        : support_(support), skin_(skin), listing_cost_(listing_cost), images_(box) {}

    // Rows point into the lists: a copy would point into the original's.
    Neighbours(Neighbours const&) = delete;
    Neighbours& operator=(Neighbours const&) = delete;

    /// Lists the neighbours anew if the particles have moved too far for the old rows. Returns whether it did: then the
    /// particles have been re-ordered, and of their images Position and Mass alone are set.
    bool update(Particles<D>& particles);

    /// The neighbours of i as a sweep uses them: each is its number times `place`, where its group of four numbers
    /// stands among those of all particles (pairs/records.hpp). As many as a pack holds may be read behind the last.
    std::span<Index const> places(std::size_t i) const {
        return {chunks_[i / particles_per_chunk].data() + first_[i], static_cast<std::size_t>(count_[i])};
    }
    static constexpr Index place = 4;

    /// The numbers of the neighbours of i.
    auto row(std::size_t i) const {
        return places(i) | std::views::transform([](Index at) { return at / place; });
    }
    /// All that is advanced.
    Targets const& all() const { return all_; }
    Targets const& walls() const { return walls_; }
    Targets const& mirrors() const { return mirrors_; }

    /// Targets for the particles among all() that `chosen` says; their blocks are cut by the same rule.
    template <class Chosen>
    Targets targets(Chosen const& chosen) const {
        return targets(0, all_.begin.back(), chosen);
    }
    Images<D> const& images() const { return images_; }

    double support() const { return support_; }
    double skin() const { return skin_; }
    std::size_t listings() const { return listings_; }

private:
    /// The displacements that some particles have had since the last listing.
    struct Displacements {
        Vector<double, D> least, most;
        void add(Displacements const& others);
        double spread() const;  ///< an upper bound of how much any two differ [m]
    };
    static Displacements none();

    bool still_valid(Particles<D> const& particles);
    void tune();
    void list(Particles<D>& particles);
    void cut(Targets& targets, std::size_t count) const;
    template <class Chosen>
    Targets targets(std::size_t begin, std::size_t end, Chosen const& chosen) const {
        Targets some;
        for (std::size_t i = begin; i < end; ++i)
            if (chosen(i)) some.particles.push_back(static_cast<Index>(i));
        if (!some.particles.empty()) cut(some, some.particles.size());
        return some;
    }

    double support_, skin_, listing_cost_;
    Images<D> images_;
    CellGrid<D> grid_;
    std::vector<std::vector<Index>> chunks_;  // the rows, chunk by chunk of particles
    static constexpr std::size_t particles_per_chunk = 256;
    std::vector<Index> first_, count_;  // of each row: where it begins in its chunk, and how long it is
    /// Positions at the last listing, from the lower corner of the grid; rounded to float, for that is as fine as a
    /// skin needs in any but a huge domain, where `rounding_` is taken off the skin.
    std::vector<float> listed_[D];
    double rounding_ = 0;  // [m]
    Targets all_, walls_, mirrors_;
    std::size_t listings_ = 0, updates_ = 0;  // updates since the last listing that saw motion
    double spread_ = 0;                       // of displacements since then, among particles that can meet [m]
    std::vector<Displacements> displaced_;    // of each block of cells
};

}  // namespace coronet
