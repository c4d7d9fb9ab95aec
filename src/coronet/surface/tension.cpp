// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/tension.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "coronet/surface/detect.hpp"

namespace coronet {

template <int D>
void find_surface(Particles<D>& particles, Neighbours<D> const& neighbours, SurfaceSettings const& settings) {
    mark_surface(particles, neighbours, settings.coverage_radius);
    reconstruct_surface(particles, neighbours, settings.fit);
}

template <int D>
void add_tension(Particles<D>& particles, SurfaceSettings const& settings) {
    auto const view = particles.view();
    std::size_t const n = particles.owned();
    auto const force = [&](std::size_t i) {  // nothing inside, where the curvature is 0
        return (-settings.tension * view.template at<Curvature>()[i] * view.template at<SurfaceArea>()[i]) *
               view.template get<SurfaceNormal>(i);
    };
    Vector<double, D> mean;
    if (settings.remove_mean_force) {
        double const count = sum_over(n, 0.0, [&](std::size_t i) { return view.template at<Surface>()[i]; });
        if (count > 0) mean = (1 / count) * sum_over(n, Vector<double, D>{}, force);
    }
    for_each(n, [&](std::size_t i) {
        if (view.template at<Surface>()[i] == 0) return;
        view.template set<Acceleration>(
            i, view.template get<Acceleration>(i) + (1 / view.template at<Mass>()[i]) * (force(i) - mean));
    });
}

template <int D>
void add_tension(Particles<D>& particles, Boundary<D> const& boundary, double sigma) {
    auto const view = particles.view();
    for_each(particles.owned(), [&](std::size_t i) {
        view.template set<Acceleration>(
            i, view.template get<Acceleration>(i) - (sigma / view.template at<Mass>()[i]) * boundary.of_size[i]);
    });
}

double capillary_step(SurfaceSettings const& settings, double rho) {
    if (settings.tension == 0) return std::numeric_limits<double>::infinity();
    double const dx = settings.spacing;
    return std::sqrt(rho * dx * dx * dx / (4 * std::numbers::pi * settings.tension));
}

#define CORONET_INSTANTIATE(D)                                                               \
    template void find_surface(Particles<D>&, Neighbours<D> const&, SurfaceSettings const&); \
    template void add_tension(Particles<D>&, SurfaceSettings const&);                        \
    template void add_tension(Particles<D>&, Boundary<D> const&, double);
CORONET_INSTANTIATE(2)
CORONET_INSTANTIATE(3)
#undef CORONET_INSTANTIATE

}  // namespace coronet
