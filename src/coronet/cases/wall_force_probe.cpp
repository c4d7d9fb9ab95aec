// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/wall_force_probe.hpp"

#include "coronet/cases/wall_fill.hpp"

#include <algorithm>

namespace coronet {

std::size_t wall_named(std::string const& name, Case const& c) {
    auto const has_it = [&](Wall const& wall) { return wall.name == name; };
    return static_cast<std::size_t>(std::find_if(c.walls.begin(), c.walls.end(), has_it) - c.walls.begin());
}

template <int D>
WallLoad<D> wall_load(Particles<D> const& particles, std::size_t wall, Vector<double, D> const& about,
                      PeriodicBox<D> const& box) {
    struct Load {
        Vector<double, D> force;
        Vector<double, 3> torque;

        Load operator+(Load const& b) const { return {force + b.force, torque + b.torque}; }
    };
    auto const view = particles.view();
    std::size_t const first = particles.begin(Role::wall);
    auto const load = sum_over(particles.count(Role::wall), Load{}, [&](std::size_t k) {
        std::size_t const i = first + k;
        if (view.template get<WallNumber>(i) != static_cast<double>(wall)) return Load{};
        auto const f = view.template get<WallForce>(i);
        auto r = view.template get<Position>(i) - about;
        r += box.shift_to_nearest(r);
        Load one{f, {}};
        one.torque[2] = r[0] * f[1] - r[1] * f[0];
        if constexpr (D == 3) {
            one.torque[0] = r[1] * f[2] - r[2] * f[1];
            one.torque[1] = r[2] * f[0] - r[0] * f[2];
        }
        return one;
    });
    return {load.force, load.torque};
}

template <int D>
WallForceProbe<D>::WallForceProbe(ProbeKeys const& keys, Case const& c)
    : name_(keys.wall), wall_(wall_named(keys.wall, c)), motion_(c.walls[wall_], c) {
    if (moves(c.walls[wall_])) box_ = periodic_box<D>(c);
    for (int k = 0; k < D; ++k) centre_[k] = c.walls[wall_].centre[k];
}

template <int D>
std::vector<std::string> WallForceProbe<D>::columns() const {
    std::vector<std::string> names;
    for (int k = 0; k < D; ++k) names.push_back(name_ + "_force_" + "xyz"[k]);
    for (int k = D == 2 ? 2 : 0; k < 3; ++k) names.push_back(name_ + "_torque_" + "xyz"[k]);
    return names;
}

template <int D>
std::vector<double> WallForceProbe<D>::sample(Snapshot<D> const& now) {
    auto const load = wall_load(now.particles, wall_, centre_ + motion_.at(now.time).displacement, box_);
    std::vector<double> row(load.force.c, load.force.c + D);
    row.insert(row.end(), load.torque.c + (D == 2 ? 2 : 0), load.torque.c + 3);
    return row;
}

template WallLoad<2> wall_load(Particles<2> const&, std::size_t, Vector<double, 2> const&, PeriodicBox<2> const&);
template WallLoad<3> wall_load(Particles<3> const&, std::size_t, Vector<double, 3> const&, PeriodicBox<3> const&);
template class WallForceProbe<2>;
template class WallForceProbe<3>;

}  // namespace coronet
