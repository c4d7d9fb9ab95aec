// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/shells_check.hpp"

#include <algorithm>
#include <cmath>

namespace coronet {

namespace {

bool is_round(Shape const& shape) {
    return shape.cuts.empty() && (shape.kind == "disc" || shape.kind == "ball" || shape.kind == "drop");
}

/// How far two shapes are from touching [m].
double gap(Shape const& a, Shape const& b) {
    double apart2 = 0;
    for (std::size_t k = 0; k < a.centre.size(); ++k) apart2 += std::pow(a.centre[k] - b.centre[k], 2);
    return std::sqrt(apart2) - a.radius * (1 + std::fabs(a.amplitude)) - b.radius * (1 + std::fabs(b.amplitude));
}

void check_column(Case const& c, Errors& errors) {
    Shape const& column = c.shapes.front();
    if (c.shapes.size() > 1 || !column.cuts.empty() || column.rotation != 0)
        say(errors, "particles.lattice = 'shells' is for a column alone, without cuts and not turned");
    if (c.domain.periodic != "x" || !c.walls.empty() || c.domain.centre[0] != column.centre[0] ||
        c.domain.size[0] != column.length)
        say(errors,
            "particles.lattice = 'shells' is for a column that goes on along x: it needs domain.periodic = 'x', with "
            "domain.size = [{}, ...] and the same middle, and no walls",
            column.length);
}

}  // namespace

void check_shells(Case const& c, Errors& errors) {
    if (c.particles.lattice != "shells" || c.shapes.empty()) return;
    if (c.particles.rotation != 0 || c.particles.origin != "node")
        say(errors,
            "particles.rotation and particles.origin are of lattices, and particles.lattice is 'shells': leave them "
            "away");
    if (c.shapes.front().kind == "column") return check_column(c, errors);
    double const radius = c.shapes.front().radius;
    bool fit = std::ranges::all_of(c.shapes, [&](Shape const& s) { return is_round(s) && s.radius == radius; });
    for (std::size_t k = 0; k < c.shapes.size(); ++k)
        for (std::size_t m = 0; m < k; ++m) fit = fit && gap(c.shapes[k], c.shapes[m]) >= 0;
    if (!fit)
        say(errors,
            "particles.lattice = 'shells' is for shapes of kind disc, ball or drop, of one radius, apart and without "
            "cuts, or for one column: use 'square' or 'hexagonal'");
    if (!c.walls.empty() || c.domain.periodic != "none")
        say(errors,
            "particles.lattice = 'shells' has no place for walls and, but for a column, periodic boundaries: use "
            "'square'");
}

}  // namespace coronet
