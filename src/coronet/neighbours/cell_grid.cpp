// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coronet/core/error.hpp"

namespace coronet {

template <int D>
std::vector<Index> CellGrid<D>::sort(Particles<D>& particles, double width) {
    std::size_t const n = particles.size();
    auto const view = particles.view();
    constexpr double infinity = std::numeric_limits<double>::infinity();

    Vector<double, D> high;
    for (int k = 0; k < D; ++k) {
        auto const x = particles.template get<Position>(k);
        for (std::size_t i = 0; i < n; ++i)
            if (!std::isfinite(x[i]))
                throw RunError(fmt::format("particle {} has left for a position that is not finite", particles.id[i]));
        low_[k] = min_over(n, infinity, [&](std::size_t i) { return x[i]; });
        high[k] = max_over(n, -infinity, [&](std::size_t i) { return x[i]; });
    }

    // Doubling the width until there are few enough cells keeps the memory bounded by the particles.
    double const most_cells = std::min(8.0 * static_cast<double>(n) + 64, 4e8);
    for (double cells = infinity; cells > most_cells; width *= 2) {
        cells = 1;
        for (int k = 0; k < D; ++k) cells *= std::floor((high[k] - low_[k]) / width) + 1;
        inverse_width_ = 1 / width;
    }
    cells_ = {1, 1, 1};
    for (int k = 0; k < D && n > 0; ++k) cells_[k] = static_cast<int>((high[k] - low_[k]) * inverse_width_) + 1;

    roles_.clear();
    for (int role = 0; role < role_count; ++role)
        if (particles.count(static_cast<Role>(role)) > 0) roles_.push_back(static_cast<Role>(role));

    // A counting sort: stable, so the order of the particles depends on their positions and former order alone.
    std::size_t const count = static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2];
    std::vector<Index> cell(n), from(n);
    begin_.assign(roles_.size() * count + 1, 0);
    for (std::size_t k = 0; k < roles_.size(); ++k) {
        std::size_t const first = particles.begin(roles_[k]);
        for_each(particles.count(roles_[k]), [&](std::size_t i) {
            cell[first + i] = static_cast<Index>(k * count + cell_of(view.template get<Position>(first + i)));
        });
    }
    for (std::size_t i = 0; i < n; ++i) ++begin_[cell[i] + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < n; ++i) from[next[cell[i]]++] = static_cast<Index>(i);
    particles.reorder(from);
    return from;
}

template class CellGrid<1>;
template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace coronet
