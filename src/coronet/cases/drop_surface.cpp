// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coronet/cases/lattice.hpp"
#include "coronet/cases/nearest_neighbour.hpp"
#include "coronet/surface/mesh_boundary.hpp"

namespace coronet {

DropSurface drop_surface(Particles<3> const& particles, Case const& c) {
    double const dx = c.particles.spacing, radius = c.surface.coverage_radius * dx;
    auto points = copy_of_positions(particles);
    Neighbours<3> neighbours(2 * radius, 0);
    neighbours.update(points);
    auto const mesh = find_mesh(points, neighbours, radius);
    DropSurface drop;
    drop.spacing_p01 = nearest_neighbour_p01(points, neighbours) / dx;
    if (mesh.triangles.empty()) return drop;

    auto const X = boundary_corners(mesh, points, dx, Lattice<3>(c).volume());
    auto const corner = [&](std::size_t t, std::size_t k) { return X[static_cast<std::size_t>(mesh.triangles[t][k])]; };
    auto const vector_area = [&](std::size_t t) {
        auto const a = corner(t, 1) - corner(t, 0), b = corner(t, 2) - corner(t, 0);
        return 0.5 *
               Vector<double, 3>{{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    };
    auto const part = mesh.parts();
    std::vector<double> volume(static_cast<std::size_t>(*std::ranges::max_element(part)) + 1, 0);
    for (std::size_t t = 0; t < part.size(); ++t)
        volume[static_cast<std::size_t>(part[t])] += dot(corner(t, 0) - X[0], vector_area(t)) / 3;
    auto const largest = static_cast<Index>(std::ranges::max_element(volume) - volume.begin());
    drop.volume = volume[static_cast<std::size_t>(largest)];
    drop.voids = static_cast<int>(std::ranges::count_if(volume, [](double v) { return v < 0; }));

    // The moment of a tetrahedron of X[0] and a triangle is its volume times the mean of its four corners.
    Vector<double, 3> centroid{};
    for (std::size_t t = 0; t < part.size(); ++t) {
        if (part[t] != largest) continue;
        auto const a = corner(t, 0) - X[0];
        centroid += dot(a, vector_area(t)) / (12 * drop.volume) * (a + (corner(t, 1) - X[0]) + (corner(t, 2) - X[0]));
    }
    centroid += X[0];
    drop.nearest = std::numeric_limits<double>::infinity();
    double weights = 0;
    for (std::size_t t = 0; t < part.size(); ++t) {
        if (part[t] != largest) continue;
        Vector<double, 3> middle{};
        double mean = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            auto const x = corner(t, k) - centroid;
            double const r = std::sqrt(norm2(x));
            drop.nearest = std::min(drop.nearest, r);
            drop.farthest = std::max(drop.farthest, r);
            mean += r / 3;
            middle += 1.0 / 3 * x;
        }
        double const solid_angle = dot(middle, vector_area(t)) / std::pow(norm2(middle), 1.5);
        drop.mean_radius += solid_angle * mean;
        weights += solid_angle;
    }
    drop.mean_radius /= weights;
    std::vector<Index> marked = mesh.particle;
    std::sort(marked.begin(), marked.end());
    drop.surface_particles = static_cast<std::size_t>(std::unique(marked.begin(), marked.end()) - marked.begin());
    return drop;
}

}  // namespace coronet
