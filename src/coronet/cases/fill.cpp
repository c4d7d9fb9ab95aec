// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/fill.hpp"

#include <algorithm>
#include <cmath>

#include "coronet/cases/column_shells.hpp"
#include "coronet/cases/lattice.hpp"
#include "coronet/cases/shells.hpp"
#include "coronet/cases/wall_fill.hpp"
#include "coronet/core/random.hpp"

namespace coronet {

template <int D>
double expected_particles(Case const& c) {
    double const cell = Lattice<D>(c).volume();
    double count = 0;
    for (Shape const& shape : c.shapes) {
        auto const half = half_extents<D>(shape);
        double box = 1;
        for (int k = 0; k < D; ++k) box *= 2 * half[k];
        count += box / cell;
    }
    return count;
}

template <int D>
Seeds<D> fill(Case const& c) {
    if (c.particles.lattice == "shells") {
        if constexpr (D == 3)
            if (c.shapes.front().kind == "column") return fill_column(c);
        return fill_shells<D>(c);
    }
    double const dx = c.particles.spacing, slack = 1e-9 * dx;
    Lattice<D> const lattice(c);
    Solid<D> const solid(c);
    auto const box = periodic_box<D>(c);
    auto const inside = [&](Vector<double, D> const& x) {
        return std::any_of(c.shapes.begin(), c.shapes.end(), [&](Shape const& s) { return holds(s, x, slack); });
    };

    Seeds<D> seeds;
    seeds.volume = lattice.volume();
    auto const lay = [&](auto const& n, Vector<double, D> x) {
        auto const is_open = [&](auto const& step) {
            auto beside = n;
            for (int k = 0; k < D; ++k) beside[k] += step[k];
            auto const there = lattice.place(beside);
            return !inside(there + box.shift_into(there)) && !solid.holds(there);
        };
        bool const surface = std::any_of(lattice.nearest().begin(), lattice.nearest().end(), is_open);
        auto const seed = static_cast<std::uint64_t>(c.particles.seed);
        for (int k = 0; k < D; ++k)
            x[k] += c.particles.jitter * dx * (2 * random(seed, seeds.size(), static_cast<std::uint64_t>(k)) - 1);
        seeds.position.push_back(x);
        seeds.surface.push_back(surface);
    };

    // Shape after shape; a point that an earlier shape holds, too, has its particle already.
    for (Shape const& shape : c.shapes) {
        Vector<double, D> centre;
        for (int k = 0; k < D; ++k) centre[k] = shape.centre[k];
        auto const new_here = [&](Vector<double, D> const& x) {
            return holds(shape, x, slack) && std::none_of(c.shapes.data(), &shape, [&](Shape const& earlier) {
                       return holds(earlier, x, slack);
                   });
        };
        lattice.for_points(
            centre, [&](Vector<double, D> const& g) { return extent(shape, turned(g, -shape.rotation)); },
            [&](auto const& n, Vector<double, D> const& x) {
                if (new_here(x) && is_in(box, x, slack) && !solid.holds(x)) lay(n, x);
            });
    }
    return seeds;
}

template Seeds<2> fill(Case const&);
template Seeds<3> fill(Case const&);
template double expected_particles<2>(Case const&);
template double expected_particles<3>(Case const&);

}  // namespace coronet
