// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A uniform grid of cells over the bounding box of the particles. After sort() the particles of each role stand in the
// order of their cells, x fastest, so that those of neighbouring cells of a row are one contiguous range: near in space
// is near in memory.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "coronet/fields/particles.hpp"

namespace coronet {

/// A contiguous range of particles, [first, last).
struct Range {
    Index first, last;
};

template <int D>
class CellGrid {
public:
    /// Lays the grid and re-orders the particles along it. Cells are at least `width` wide [m]; wider where particles
    /// have flown so far apart that cells of that width would outnumber them. Returns where the particles stood before,
    /// one by one. Throws RunError at a position that is not finite.
    std::vector<Index> sort(Particles<D>& particles, double width);

    /// The particles of the cells around the one of `x`, a row of a role at a time: everything within `width` of x is
    /// among them. Roles that `wanted` denies are passed by.
    template <class Wanted, class Visit>
    void for_rows_around(Vector<double, D> const& x, Wanted const& wanted, Visit const& visit) const {
        std::array<int, 3> low{}, high{};
        for (int k = 0; k < D; ++k) {
            int const cell = cell_along(x[k], k);
            low[k] = std::max(cell - 1, 0);
            high[k] = std::min(cell + 1, cells_[k] - 1);
        }
        for (int c2 = low[2]; c2 <= high[2]; ++c2)
            for (int c1 = low[1]; c1 <= high[1]; ++c1) {
                std::size_t const row = (static_cast<std::size_t>(c2) * cells_[1] + c1) * cells_[0];
                for_roles(row + low[0], row + high[0] + 1, wanted, visit);
            }
    }

    /// Cells taken two by two along each axis, as they lay at the last sort().
    std::array<int, 3> pairs_of_cells() const {
        return {(cells_[0] + 1) / 2, (cells_[1] + 1) / 2, (cells_[2] + 1) / 2};
    }
    /// The particles of such a block of cells, a row at a time.
    template <class Visit>
    void for_rows_of_block(std::array<int, 3> const& block, Visit const& visit) const {
        int const first = 2 * block[0], last = std::min(first + 2, cells_[0]);
        for (int c2 = 2 * block[2]; c2 < std::min(2 * block[2] + 2, cells_[2]); ++c2)
            for (int c1 = 2 * block[1]; c1 < std::min(2 * block[1] + 2, cells_[1]); ++c1) {
                std::size_t const row = (static_cast<std::size_t>(c2) * cells_[1] + c1) * cells_[0];
                for_roles(
                    row + first, row + last, [](Role) { return true; }, visit);
            }
    }

    /// The lower corner [m].
    Vector<double, D> const& low() const { return low_; }
    /// The largest length along an axis [m].
    double extent() const { return width() * *std::max_element(cells_.begin(), cells_.end()); }
    /// The width of a cell [m].
    double width() const { return 1 / inverse_width_; }

private:
    template <class Wanted, class Visit>
    void for_roles(std::size_t first, std::size_t last, Wanted const& wanted, Visit const& visit) const {
        std::size_t const cells = static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2];
        for (std::size_t k = 0; k < roles_.size(); ++k)
            if (wanted(roles_[k])) visit(Range{begin_[k * cells + first], begin_[k * cells + last]});
    }
    int cell_along(double x, int k) const {
        int const cell = static_cast<int>((x - low_[k]) * inverse_width_);
        return std::min(std::max(cell, 0), cells_[k] - 1);
    }
    std::size_t cell_of(Vector<double, D> const& x) const {
        std::size_t cell = 0;
        for (int k = D - 1; k >= 0; --k) cell = cell * cells_[k] + static_cast<std::size_t>(cell_along(x[k], k));
        return cell;
    }

    Vector<double, D> low_;
    double inverse_width_ = 0;
    std::array<int, 3> cells_ = {1, 1, 1};
    std::vector<Role> roles_;   // that there are
    std::vector<Index> begin_;  // of each cell, role after role
};

}  // namespace coronet
