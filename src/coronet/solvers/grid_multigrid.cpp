// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/solvers/grid_multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coronet/core/parallel.hpp"

namespace coronet {

namespace {

/// Offset -1, 0, 1 along axis k of entry m of a row of 3^D.
constexpr int offset(int m, int k) {
    for (; k > 0; --k) m /= 3;
    return m % 3 - 1;
}

/// What corner b of a cell with children takes part in at corner c of the child `child`, both as bits along the axes.
template <int D>
constexpr double share(int child, int c, int b) {
    double s = 1;
    for (int k = 0; k < D; ++k) {
        int const half = (child >> k & 1) + (c >> k & 1);  // position in the parent: 0, 1/2 or 1
        s *= (b >> k & 1) ? 0.5 * half : 1 - 0.5 * half;
    }
    return s;
}

/// A coarse hat function at the fine node m of the 3^D around its own.
template <int D>
constexpr double hat_at(int m) {
    double s = 1;
    for (int k = 0; k < D; ++k) s *= offset(m, k) == 0 ? 1 : 0.5;
    return s;
}

}  // namespace

/// The cells that hold any item, numbered in the order of their first item, with their nodes; cell_of says each item's,
/// -1 for one whose first index is negative.
template <int D>
auto GridMultigrid<D>::lay(std::array<int, D> const& cells, std::vector<std::array<int, D>> const& cell_of_item,
                           std::vector<Index>& cell_of) -> Level {
    Level level;
    level.cells = cells;
    std::size_t box = 1, box_nodes = 1;
    for (int k = 0; k < D; ++k) box *= static_cast<std::size_t>(cells[k]), box_nodes *= cells[k] + std::size_t{1};
    auto const at = [&](std::array<int, D> const& c, int more) {
        std::size_t place = 0;
        for (int k = D - 1; k >= 0; --k) place = place * static_cast<std::size_t>(cells[k] + more) + c[k];
        return place;
    };
    std::vector<Index> number(box, -1), node(box_nodes, -1);
    cell_of.resize(cell_of_item.size());
    for (std::size_t i = 0; i < cell_of.size(); ++i) {
        cell_of[i] = -1;
        if (cell_of_item[i][0] < 0) continue;
        Index& known = number[at(cell_of_item[i], 0)];
        if (known < 0) {
            known = static_cast<Index>(level.cell.size());
            level.cell.push_back(cell_of_item[i]);
        }
        cell_of[i] = known;
    }

    std::vector<std::array<int, D>> place_of_node;
    level.corner.resize(level.cell.size());
    for (std::size_t c = 0; c < level.cell.size(); ++c)
        for (int b = 0; b < corners; ++b) {
            auto place = level.cell[c];
            for (int k = 0; k < D; ++k) place[k] += b >> k & 1;
            Index& known = node[at(place, 1)];
            if (known < 0) {
                known = static_cast<Index>(place_of_node.size());
                place_of_node.push_back(place);
                int colour = 0;
                for (int k = 0; k < D; ++k) colour |= (place[k] & 1) << k;
                level.colour[colour].push_back(known);
            }
            level.corner[c][b] = known;
        }

    std::size_t const nodes = place_of_node.size();
    auto const spare = static_cast<Index>(nodes);
    level.around.resize(nodes);
    level.near.resize(nodes);
    for_each(nodes, [&](std::size_t n) {
        for (int m = 0; m < reach; ++m) {
            auto place = place_of_node[n];
            bool inside = true;
            for (int k = 0; k < D; ++k) {
                place[k] += offset(m, k);
                inside = inside && place[k] >= 0 && place[k] <= cells[k];
            }
            Index const known = inside ? node[at(place, 1)] : -1;
            level.near[n][m] = known < 0 ? spare : known;
        }
        for (int b = 0; b < corners; ++b) {  // the cell whose corner b this node is
            auto place = place_of_node[n];
            bool inside = true;
            for (int k = 0; k < D; ++k) {
                place[k] -= b >> k & 1;
                inside = inside && place[k] >= 0 && place[k] < cells[k];
            }
            level.around[n][b] = inside ? number[at(place, 0)] : -1;
        }
    });
    level.r.assign(nodes + 1, 0.0);
    level.z.assign(nodes + 1, 0.0);
    level.left.assign(nodes + 1, 0.0);
    return level;
}

/// A fine node takes the mean over both neighbours along each axis, which are one where it lies on a coarse one. Cells
/// that share a node say the same of it.
template <int D>
void GridMultigrid<D>::link(Level& fine, Level& coarse) {
    fine.coarser.resize(fine.near.size());
    coarse.finer.resize(coarse.near.size());
    for (auto& around : coarse.finer) around.fill(static_cast<Index>(fine.near.size()));
    for (std::size_t c = 0; c < fine.cell.size(); ++c)
        for (int b = 0; b < corners; ++b) {
            Index const n = fine.corner[c][b];
            for (int pick = 0; pick < corners; ++pick) {
                int to = 0, m = 0;
                for (int k = D - 1; k >= 0; --k) {
                    int const half = (fine.cell[c][k] & 1) + (b >> k & 1);  // position in the parent: 0, 1/2 or 1
                    int const side = half == 1 ? pick >> k & 1 : half / 2;
                    to |= side << k;
                    m = 3 * m + half - 2 * side + 1;
                }
                Index const above = coarse.corner[fine.parent[c]][to];
                fine.coarser[n][pick] = above;
                coarse.finer[above][m] = n;
            }
        }
}

template <int D>
void GridMultigrid<D>::assemble(Level& level, std::vector<Element> const& elements) const {
    std::size_t const nodes = level.near.size();
    level.matrix.resize(nodes);
    level.inverse.resize(nodes);
    for_each(nodes, [&](std::size_t n) {
        auto& row = level.matrix[n];
        row.fill(0);
        for (int b = 0; b < corners; ++b) {
            Index const c = level.around[n][b];
            if (c < 0) continue;
            for (int other = 0; other < corners; ++other) {
                int m = 0;
                for (int k = D - 1; k >= 0; --k) m = 3 * m + 1 + (other >> k & 1) - (b >> k & 1);
                row[m] += elements[c][b * corners + other];
            }
        }
        double const d = row[reach / 2];
        level.inverse[n] = d > std::numeric_limits<double>::min() ? 1 / d : 0;
    });
}

template <int D>
auto GridMultigrid<D>::hats(std::size_t point) const -> Corners {
    Corners hat;
    for (int b = 0; b < corners; ++b) {
        double s = 1;
        for (int k = 0; k < D; ++k) s *= (b >> k & 1) ? place_[point][k] : 1.0 - place_[point][k];
        hat[b] = s;
    }
    return hat;
}

template <int D>
void GridMultigrid<D>::set_up(Particles<D> const& particles, SmoothEnergy const& energy,
                              std::span<double const> diagonal, double spacing) {
    std::size_t const n = particles.size();
    auto const view = particles.view();
    diagonal_ = diagonal;
    levels_.clear();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector<double, D> low, high;
    for (int k = 0; k < D; ++k) {
        low[k] = min_over(n, infinity, [&](std::size_t i) { return view.template at<Position>(k)[i]; });
        high[k] = max_over(n, -infinity, [&](std::size_t i) { return view.template at<Position>(k)[i]; });
    }
    double const most_cells = std::min(64.0 * static_cast<double>(n) + 64, 1e9);
    std::array<int, D> cells;
    for (double count = infinity; count > most_cells;) {
        count = 1;
        for (int k = 0; k < D; ++k) count *= std::floor((high[k] - low[k]) / spacing) + 1;
        if (count > most_cells) spacing *= 2;
    }
    for (int k = 0; k < D; ++k) cells[k] = static_cast<int>((high[k] - low[k]) / spacing) + 1;

    std::vector<std::array<int, D>> cell(n);
    place_.resize(n);
    for_each(n, [&](std::size_t i) {
        for (int k = 0; k < D; ++k) {
            double const s = (view.template at<Position>(k)[i] - low[k]) / spacing;
            cell[i][k] = std::min(static_cast<int>(s), cells[k] - 1);
            place_[i][k] = static_cast<float>(s - cell[i][k]);
        }
    });
    // A point without energy is none of the grid's business.
    for (std::size_t i = 0; i < n; ++i)
        if (!(energy.a[i] + energy.e[i] > 0)) cell[i][0] = -1;
    levels_.push_back(lay(cells, cell, cell_of_point_));
    std::size_t const filled = levels_[0].cell.size();
    begin_.assign(filled + 1, 0);
    for (Index const c : cell_of_point_)
        if (c >= 0) ++begin_[c + 1];
    for (std::size_t c = 0; c < filled; ++c) begin_[c + 1] += begin_[c];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    points_.resize(begin_[filled]);
    for (std::size_t i = 0; i < n; ++i)
        if (Index const c = cell_of_point_[i]; c >= 0) points_[next[c]++] = static_cast<Index>(i);

    std::vector<Element> elements(filled);
    for_each(filled, [&](std::size_t c) {
        auto& E = elements[c];
        E.fill(0);
        for (std::size_t at = begin_[c]; at < begin_[c + 1]; ++at) {
            auto const i = static_cast<std::size_t>(points_[at]);
            Corners const hat = hats(i);
            Vector<double, D> slope_of[corners];
            for (int b = 0; b < corners; ++b) {
                for (int k = 0; k < D; ++k) {
                    double slope = (b >> k & 1 ? 1 : -1) / spacing;
                    for (int l = 0; l < D; ++l)
                        if (l != k) slope *= (b >> l & 1) ? place_[i][l] : 1.0 - place_[i][l];
                    slope_of[b][k] = slope;
                }
            }
            for (int b = 0; b < corners; ++b)
                for (int other = 0; other < corners; ++other)
                    E[b * corners + other] +=
                        energy.a[i] * dot(slope_of[b], slope_of[other]) + energy.e[i] * hat[b] * hat[other];
        }
    });
    assemble(levels_[0], elements);

    while (*std::max_element(cells.begin(), cells.end()) > 2) {
        Level& fine = levels_.back();
        for (int& c : cells) c = (c + 1) / 2;
        std::vector<std::array<int, D>> parents = fine.cell;
        for (auto& p : parents)
            for (int& c : p) c /= 2;
        Level coarse = lay(cells, parents, fine.parent);
        link(fine, coarse);
        std::vector<Element> sums(coarse.cell.size());
        for (auto& E : sums) E.fill(0);
        for (std::size_t c = 0; c < fine.cell.size(); ++c) {
            int child = 0;
            for (int k = 0; k < D; ++k) child |= (fine.cell[c][k] & 1) << k;
            Element half;  // E R
            for (int b = 0; b < corners; ++b)
                for (int to = 0; to < corners; ++to) {
                    double s = 0;
                    for (int m = 0; m < corners; ++m) s += elements[c][b * corners + m] * share<D>(child, m, to);
                    half[b * corners + to] = s;
                }
            auto& E = sums[fine.parent[c]];
            for (int from = 0; from < corners; ++from)
                for (int to = 0; to < corners; ++to)
                    for (int m = 0; m < corners; ++m)
                        E[from * corners + to] += share<D>(child, m, from) * half[m * corners + to];
        }
        elements = std::move(sums);
        assemble(coarse, elements);
        levels_.push_back(std::move(coarse));
    }
    cell_sums_.resize(filled);
}

template <int D>
double GridMultigrid<D>::residual(Level const& level, std::size_t n) {
    double s = level.r[n];
    for (int m = 0; m < reach; ++m) s -= level.matrix[n][m] * level.z[level.near[n][m]];
    return s;
}

template <int D>
void GridMultigrid<D>::smooth(Level& level, int colour) {
    auto const& nodes = level.colour[colour];
    for_each(nodes.size(), [&](std::size_t k) {
        auto const n = static_cast<std::size_t>(nodes[k]);
        level.z[n] += level.inverse[n] * residual(level, n);
    });
}

template <int D>
void GridMultigrid<D>::cycle(std::size_t l) {
    Level& level = levels_[l];
    bool const coarsest = l + 1 == levels_.size();
    std::fill(level.z.begin(), level.z.end(), 0.0);
    for (int sweep = 0; sweep < (coarsest ? 4 : 1); ++sweep)
        for (int colour = 0; colour < corners; ++colour) smooth(level, colour);
    if (!coarsest) {
        Level& coarse = levels_[l + 1];
        for_each(level.nodes(), [&](std::size_t n) { level.left[n] = residual(level, n); });
        for_each(coarse.nodes(), [&](std::size_t n) {
            double s = 0;
            for (int m = 0; m < reach; ++m) s += hat_at<D>(m) * level.left[coarse.finer[n][m]];
            coarse.r[n] = s;
        });
        cycle(l + 1);
        for_each(level.nodes(), [&](std::size_t n) {
            double s = 0;
            for (Index const from : level.coarser[n]) s += coarse.z[from];
            level.z[n] += s / corners;
        });
    }
    for (int sweep = 0; sweep < (coarsest ? 4 : 1); ++sweep)
        for (int colour = corners - 1; colour >= 0; --colour) smooth(level, colour);
}

template <int D>
void GridMultigrid<D>::operator()(std::span<double const> r, std::span<double> z) {
    Level& finest = levels_[0];
    for_each(cell_sums_.size(), [&](std::size_t c) {
        Corners sums{};
        for (std::size_t at = begin_[c]; at < begin_[c + 1]; ++at) {
            auto const i = static_cast<std::size_t>(points_[at]);
            Corners const hat = hats(i);
            for (int b = 0; b < corners; ++b) sums[b] += hat[b] * r[i];
        }
        cell_sums_[c] = sums;
    });
    for_each(finest.nodes(), [&](std::size_t n) {
        double s = 0;
        for (int b = 0; b < corners; ++b)
            if (Index const c = finest.around[n][b]; c >= 0) s += cell_sums_[c][b];
        finest.r[n] = s;
    });
    cycle(0);
    for_each(r.size(), [&](std::size_t i) {
        double s = diagonal_[i] > 0 ? r[i] / diagonal_[i] : r[i];
        if (Index const c = cell_of_point_[i]; c >= 0) {
            Corners const hat = hats(i);
            for (int b = 0; b < corners; ++b) s += hat[b] * finest.z[finest.corner[c][b]];
        }
        z[i] = s;
    });
}

template <int D>
std::vector<std::size_t> GridMultigrid<D>::nodes() const {
    std::vector<std::size_t> counts;
    for (Level const& level : levels_) counts.push_back(level.nodes());
    return counts;
}

template class GridMultigrid<2>;
template class GridMultigrid<3>;

}  // namespace coronet
