// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/boundary_finder.hpp"

#include <cmath>
#include <optional>

namespace coronet {

template <>
Boundary<2> BoundaryFinder<2>::operator()(Particles<2>& particles, Neighbours<2> const& neighbours,
                                          SurfaceSettings const& settings) {
    return find_boundary(particles, neighbours, settings.coverage_radius, settings.spacing, settings.volume);
}

template <>
Boundary<3> BoundaryFinder<3>::operator()(Particles<3>& particles, Neighbours<3> const& neighbours,
                                          SurfaceSettings const& settings) {
    auto const boundary_now = [&] {
        return boundary_of(mesh_, particles, neighbours, settings.coverage_radius, settings.spacing, settings.volume);
    };
    if (listing_ == neighbours.listings()) return boundary_now();

    std::optional<double> before;  // with the triangles of before
    if (listing_ > 0) {
        std::vector<Index> place(particles.owned());
        for (std::size_t i = 0; i < place.size(); ++i)
            place[static_cast<std::size_t>(particles.id[i])] = static_cast<Index>(i);
        for (std::size_t v = 0; v < of_mesh_.size(); ++v)
            mesh_.particle[v] = place[static_cast<std::size_t>(of_mesh_[v])];
        before = boundary_now().total_size();
    }
    listing_ = neighbours.listings();
    mesh_ = find_mesh(particles, neighbours, settings.coverage_radius);
    of_mesh_.resize(mesh_.vertices());
    for (std::size_t v = 0; v < of_mesh_.size(); ++v)
        of_mesh_[v] = particles.id[static_cast<std::size_t>(mesh_.particle[v])];
    auto boundary = boundary_now();
    if (before) jumps_ += std::fabs(boundary.total_size() - *before);
    return boundary;
}

}  // namespace coronet
