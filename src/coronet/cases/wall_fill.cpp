// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_fill.hpp"

#include <algorithm>
#include <set>

#include "coronet/cases/lattice.hpp"
#include "coronet/cases/wall_mirror.hpp"

namespace coronet {

template <int D>
PeriodicBox<D> periodic_box(Case const& c) {
    PeriodicBox<D> box;
    for (int k = 0; k < D; ++k) {
        box.periodic[k] = c.domain.periodic != "none" && c.domain.periodic.find("xyz"[k]) != std::string::npos;
        if (!box.periodic[k]) continue;
        box.size[k] = c.domain.size[k];
        box.low[k] = c.domain.centre[k] - c.domain.size[k] / 2;
    }
    return box;
}

template <int D>
double lattice_slope_moment(Case const& c, Kernel const& kernel) {
    Lattice<D> const lattice(c);
    auto const here = lattice.place({});
    auto const extent = [&](Vector<double, D> const& g) { return kernel.support * std::sqrt(norm2(g)); };
    double trace = 0;
    lattice.for_points(here, extent, [&](auto const&, Vector<double, D> const& x) {
        double const r2 = norm2(x - here);
        trace -= lattice.volume() * kernel(r2).F * r2;
    });
    return trace / D;
}

bool moves(Wall const& wall) {
    auto const zero = [](std::string const& text) { return text == "0"; };
    return wall.turn != "0" || !std::all_of(wall.displacement.begin(), wall.displacement.end(), zero);
}

template <int D>
Solid<D>::Solid(Case const& c, Wall const* one) : walls_(c.walls), slack_(1e-9 * c.particles.spacing) {
    for (std::size_t k = 0; k < walls_.size(); ++k) {
        bool const with_it = one && (moves(*one) ? &walls_[k] == one : !moves(walls_[k]));
        if (!one || with_it) own_.push_back(k);
    }
}

template <int D>
Solid<D> Solid<D>::at_rest(Case const& c) {
    Solid solid(c);
    std::erase_if(solid.own_, [&](std::size_t k) { return moves(c.walls[k]); });
    return solid;
}

template <int D>
auto Solid<D>::deepest(Vector<double, D> const& x) const -> Depth {
    Depth found;
    for (std::size_t const k : own_) {
        auto const point = nearest_wall_point(walls_[k], x);
        if (-point.distance > found.depth) found = {-point.distance, point.normal, k};
    }
    return found;
}

template <int D>
WallSeeds<D> fill_walls(Case const& c) {
    double const dx = c.particles.spacing, slack = 1e-9 * dx, reach = c.method.support * dx;
    Lattice<D> const lattice(c);
    auto const box = periodic_box<D>(c);

    WallSeeds<D> seeds;
    std::set<std::array<int, D>> laid;  // by an earlier wall at rest
    for (Wall const& wall : c.walls) {
        Solid<D> const solid(c, &wall);
        bool const alone = moves(wall);
        auto const half = half_extents<D>(wall);
        // The part of the wall's surroundings that is in the box.
        Vector<double, D> centre, around;
        for (int k = 0; k < D; ++k) {
            double low = wall.centre[k] - half[k] - reach, high = wall.centre[k] + half[k] + reach;
            if (box.periodic[k]) low = std::max(low, box.low[k]), high = std::min(high, box.low[k] + box.size[k]);
            centre[k] = (low + high) / 2;
            around[k] = (high - low) / 2;
        }
        auto const extent = [&](Vector<double, D> const& g) {
            double sum = 0;
            for (int k = 0; k < D; ++k) sum += std::fabs(g[k]) * around[k];
            return sum;
        };
        lattice.for_points(centre, extent, [&](auto const& n, Vector<double, D> const& x) {
            if (!is_in(box, x, slack)) return;
            auto const own = nearest_wall_point(wall, x);
            if (own.distance >= slack || own.distance < -reach) return;
            auto const first = solid.deepest(x);
            if (first.depth > reach || (!alone && c.walls.size() > 1 && !laid.insert(n).second)) return;
            auto const mirror = mirror_of(solid, box, x, dx, reach);
            if (!mirror) return;
            seeds.position.push_back(x);
            seeds.to_mirror.push_back(*mirror - x);
            seeds.wall.push_back(first.wall);
        });
    }
    return seeds;
}

template PeriodicBox<2> periodic_box(Case const&);
template PeriodicBox<3> periodic_box(Case const&);
template double lattice_slope_moment<2>(Case const&, Kernel const&);
template double lattice_slope_moment<3>(Case const&, Kernel const&);
template class Solid<2>;
template class Solid<3>;
template WallSeeds<2> fill_walls(Case const&);
template WallSeeds<3> fill_walls(Case const&);

}  // namespace coronet
