// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/surface/boundary_finder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coronet {

namespace {

using Lines = std::vector<std::vector<std::int64_t>>;

/// Of the particles along each loop, in an order that does not depend on where a loop is begun.
Lines identities(Outline const& outline, Particles<2> const& particles) {
    Lines lines;
    for (Loop const& loop : outline.loops) {
        auto& line = lines.emplace_back();
        for (Index const i : loop.particles) line.push_back(particles.id[static_cast<std::size_t>(i)]);
        std::ranges::rotate(line, std::ranges::min_element(line));
    }
    std::ranges::sort(lines);
    return lines;
}

/// Of the boundary along lines of before, where their particles are now [m].
double length(Lines const& lines, Particles<2> const& particles, SurfaceSettings const& settings) {
    std::vector<std::size_t> place(particles.owned());
    for (std::size_t i = 0; i < place.size(); ++i) place[static_cast<std::size_t>(particles.id[i])] = i;
    double sum = 0;
    for (auto const& line : lines) {
        Polygon points;
        for (std::int64_t const id : line)
            points.push_back(particles.view().get<Position>(place[static_cast<std::size_t>(id)]));
        sum += measure(boundary_corners(points, settings.spacing, settings.volume)).perimeter;
    }
    return sum;
}

}  // namespace

template <>
Boundary<2> BoundaryFinder<2>::operator()(Particles<2>& particles, Neighbours<2> const& neighbours,
                                          SurfaceSettings const& settings) {
    double const radius = settings.coverage_radius;
    if (listing_ != neighbours.listings()) candidates_ = surface_candidates(particles, neighbours, radius);
    listing_ = neighbours.listings();
    auto const outline = find_outline(particles, neighbours, radius, candidates_);
    auto const boundary = boundary_along(outline, particles, neighbours, radius, settings.spacing, settings.volume);
    auto lines = identities(outline, particles);
    if (!lines_.empty() && lines != lines_)
        jumps_ += std::fabs(boundary.total_size() - length(lines_, particles, settings));
    lines_ = std::move(lines);
    return boundary;
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
