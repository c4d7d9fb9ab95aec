// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A multigrid preconditioner for operators on scattered points whose energy is, for smooth p, that of a Laplacian with
// a boundary,
//     p^T A p = sum_i a_i |grad p(x_i)|^2 + e_i p(x_i)^2,
// up to a factor that does not grow with the number of points. What is known of the boundary is in e_i: the row sums of
// a matrix, or of a pressure operator that is a square the size of its force of a constant pressure, which is nothing
// inside and at a free surface the push that makes p vanish there.
// Points have no natural hierarchy, so an auxiliary Cartesian grid carries the smooth part: with multilinear
// interpolation P from its nodes, P^T A P is summed cell by cell from the points inside; hat functions of a grid with
// twice the spacing are sums of those of the finer one, so all coarser matrices follow from the cells' (the Galerkin
// products, without further assumptions about the shape of the liquid). Only cells that hold points exist. One V-cycle
// with Gauss-Seidel sweeps in 2^D colours, forward on the way down and backward on the way up, approximates the inverse
// on the grid; division by the diagonal of A adds what the grid cannot see:
//     z = D^-1 r + P (V-cycle) P^T r,
// the additive form of Bramble, Pasciak and Xu, Math. Comp. 55 (1990) 1, with one auxiliary grid (Xu, Computing 56
// (1996) 215). It is symmetric and positive definite, and the same bits for any number of threads.

#include <array>
#include <span>
#include <vector>

#include "coronet/fields/particles.hpp"

namespace coronet {

/// What A does to smooth p, point by point.
struct SmoothEnergy {
    std::vector<double> a;
    std::vector<double> e;  ///< in units of a/m^2
};

template <int D>
class GridMultigrid {
public:
    /// Particles at Position with the energy of A; the finest grid has this spacing [m], or twice that, and
    /// so on, where they lie so far apart that nodes would outnumber them by far. The diagonal of A is borrowed.
    void set_up(Particles<D> const& particles, SmoothEnergy const& energy, std::span<double const> diagonal,
                double spacing);

    void operator()(std::span<double const> r, std::span<double> z);

    /// Nodes of the grids, the finest first.
    std::vector<std::size_t> nodes() const;

private:
    static constexpr int corners = 1 << D, reach = D == 2 ? 9 : 27;
    using Corners = std::array<double, corners>;
    using Element = std::array<double, corners * corners>;

    struct Level {
        std::array<int, D> cells = {};                    // of the box
        std::vector<std::array<int, D>> cell;             // those that exist
        std::vector<std::array<Index, corners>> corner;   // their nodes
        std::vector<std::array<Index, corners>> around;   // of each node: the cells around it, or -1
        std::vector<std::array<Index, reach>> near;       // of each node: the nodes around it, or the spare one
        std::vector<std::array<double, reach>> matrix;    // its row, in the same order
        std::vector<double> inverse;                      // of the diagonal
        std::vector<Index> colour[corners];               // nodes that no matrix entry connects
        std::vector<Index> parent;                        // of each cell: the cell of the next level
        std::vector<std::array<Index, corners>> coarser;  // of each node: those of the next level whose mean it takes
        std::vector<std::array<Index, reach>> finer;  // of each node: those of the level before it, or the spare one
        std::vector<double> r, z, left;               // with a spare entry at the end, zero; left: the residual

        std::size_t nodes() const { return matrix.size(); }
    };

    Level lay(std::array<int, D> const& cells, std::vector<std::array<int, D>> const& cell_of_item,
              std::vector<Index>& cell_of);
    static void link(Level& fine, Level& coarse);
    void assemble(Level& level, std::vector<Element> const& elements) const;
    static void smooth(Level& level, int colour);
    static double residual(Level const& level, std::size_t node);
    void cycle(std::size_t level);
    Corners hats(std::size_t point) const;

    std::span<double const> diagonal_;
    std::vector<Level> levels_;
    std::vector<Index> cell_of_point_, points_;  // the points, cell by cell
    std::vector<std::size_t> begin_;             // where a cell's points begin
    std::vector<std::array<float, D>> place_;    // of each point in its cell, from 0 to 1
    std::vector<Corners> cell_sums_;
};

}  // namespace coronet
