// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Neighbour lists kept over several steps: each particle's row names all others within support + skin. Until two
// particles can have come skin closer, a row still holds everything inside the support; then the rows are listed anew
// and the particles re-ordered along the cell grid. A common translation of all particles does not count as coming
// closer.
//
// Rows hold each pair twice (j in the row of i, i in the row of j): every particle gathers its own sums.

#include <span>
#include <vector>

#include "coronet/neighbours/cell_grid.hpp"

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
    /// support and skin in m.
    Neighbours(double support, double skin) : support_(support), skin_(skin) {}

    // Rows point into the lists: a copy would point into the original's.
    Neighbours(Neighbours const&) = delete;
    Neighbours& operator=(Neighbours const&) = delete;

    /// Lists the neighbours anew if the particles have moved too far for the old rows. Returns whether it did: then the
    /// particles have been re-ordered.
    bool update(Particles<D>& particles);

    std::span<Index const> row(std::size_t i) const { return {first_[i], static_cast<std::size_t>(count_[i])}; }
    Targets const& all() const { return all_; }

    /// Targets for the particles that `chosen` says; their blocks are cut by the same rule.
    template <class Chosen>
    Targets targets(Chosen const& chosen) const {
        Targets some;
        for (std::size_t i = 0; i < count_.size(); ++i)
            if (chosen(i)) some.particles.push_back(static_cast<Index>(i));
        if (!some.particles.empty()) cut(some, some.particles.size());
        return some;
    }

    double support() const { return support_; }
    std::size_t longest_row() const { return longest_; }
    std::size_t listings() const { return listings_; }

private:
    bool still_valid(Particles<D> const& particles) const;
    void list(Particles<D>& particles);
    void cut(Targets& targets, std::size_t count) const;

    double support_, skin_;
    CellGrid<D> grid_;
    std::vector<std::vector<Index>> chunks_;  // the rows, chunk by chunk of particles
    std::vector<Index const*> first_;
    std::vector<Index> count_;
    Targets all_;
    std::size_t longest_ = 0, listings_ = 0;
};

}  // namespace coronet
