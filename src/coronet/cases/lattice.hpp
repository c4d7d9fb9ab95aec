// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The lattice on which particles are laid: square, or hexagonal (in 3D face-centred cubic), turned as the case says. A
// point of it has whole numbers, one for each axis.

#include <array>
#include <cmath>
#include <vector>

#include "coronet/cases/case.hpp"
#include "coronet/cases/shapes.hpp"

namespace coronet {

template <int D>
class Lattice {
public:
    using Point = std::array<int, D>;

    explicit Lattice(Case const& c);

    Vector<double, D> place(Point const& n) const {
        Vector<double, D> in_cells;
        for (int k = 0; k < D; ++k) in_cells[k] = n[k] + offset_;
        return turned(spacing_ * (basis_ * in_cells), rotation_);
    }
    /// Of a cell [m^D].
    double volume() const { return std::fabs(determinant(basis_)) * std::pow(spacing_, D); }
    /// The steps to the nearest points.
    std::vector<Point> const& nearest() const { return nearest_; }
    /// Whether a translation by `step` [m] takes points to points.
    bool repeats_after(Vector<double, D> const& step) const;

    /// Calls visit(n, place(n)) for all points of a body around `centre` and some beside it; extent(g) is how far the
    /// body goes from its centre along a direction g, times the length of g.
    template <class Extent, class Visit>
    void for_points(Vector<double, D> const& centre, Extent const& extent, Visit const& visit) const {
        auto const middle = in_lattice(centre);
        Point low, high;
        for (int k = 0; k < D; ++k) {
            Vector<double, D> row;  // of the inverse basis: the direction in which the index k grows
            for (int m = 0; m < D; ++m) row[m] = inverse_(k, m);
            double const half = extent(turned(row, rotation_)) / spacing_ + 2;
            low[k] = static_cast<int>(std::floor(middle[k] - half));
            high[k] = static_cast<int>(std::ceil(middle[k] + half));
        }
        Point n = low;
        for (bool more = true; more;) {
            visit(n, place(n));
            more = false;
            for (int k = 0; k < D && !more; ++k) {
                more = ++n[k] <= high[k];
                if (!more) n[k] = low[k];
            }
        }
    }

private:
    Vector<double, D> in_lattice(Vector<double, D> const& x) const {
        return inverse_ * turned((1 / spacing_) * x, -rotation_);
    }

    double spacing_, rotation_, offset_;
    Matrix<double, D> basis_, inverse_;  // columns, in spacings
    std::vector<Point> nearest_;
};

}  // namespace coronet
