// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/schemes/coupled_zones.hpp"

namespace coronet {

template <int D>
void CoupledZones<D>::mark(Particles<D>& particles, Neighbours<D> const& neighbours) {
    enum Zone : char { is_deep, is_near, is_border, is_exterior };
    std::size_t const n = particles.owned();
    auto const view = particles.view();
    auto const surface = particles.template get<Surface>();
    std::vector<Zone> zone(n, is_deep);
    // The few that are not deep mark their neighbours: one after another, since two may mark the same.
    auto const mark = [&](Zone as, auto const& from, auto const& reaches) {
        for (std::size_t i = 0; i < n; ++i)
            if (from(i))
                for (Index const j : neighbours.row(i)) {
                    auto const k = static_cast<std::size_t>(j);
                    if (zone[k] < as && reaches(i, k)) zone[k] = as;
                }
    };
    double const H2 = neighbours.support() * neighbours.support();
    auto const inside = [&](std::size_t i, std::size_t j) {
        return norm2(view.template get<Position>(i) - view.template get<Position>(j)) < H2;
    };
    auto const always = [](std::size_t, std::size_t) { return true; };
    for (std::size_t i = 0; i < n; ++i)
        if (surface[i] > 0) zone[i] = is_exterior;
    mark(
        is_exterior, [&](std::size_t i) { return surface[i] > 0; }, inside);
    mark(
        is_border, [&](std::size_t i) { return zone[i] == is_exterior; }, always);
    mark(
        is_near, [&](std::size_t i) { return zone[i] >= is_border; }, always);

    for (std::size_t i = 0; i < n; ++i) {
        view.template at<Exterior>()[i] = zone[i] == is_exterior;
        view.template at<FellBack>()[i] = 0;  // set where gradients are corrected
    }
    exterior = neighbours.targets([&](std::size_t i) { return zone[i] == is_exterior; });
    border = neighbours.targets([&](std::size_t i) { return zone[i] == is_border; });
    near = neighbours.targets([&](std::size_t i) { return zone[i] == is_near; });
    deep = neighbours.targets([&](std::size_t i) { return zone[i] == is_deep; });
    corrected = neighbours.targets([&](std::size_t i) { return zone[i] >= is_border; });
    plain = neighbours.targets([&](std::size_t i) { return zone[i] < is_border; });
}

template struct CoupledZones<2>;
template struct CoupledZones<3>;

}  // namespace coronet
