// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coronet/cases/lattice.hpp"
#include "coronet/cases/nearest_neighbour.hpp"
#include "coronet/surface/boundary.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

double polar_angle(Vector<double, 2> const& x) { return std::atan2(x[1], x[0]); }

/// visit(r1, r2, theta, turn) of each side: from r1 at theta - turn/2 to r2 at theta + turn/2.
template <class Visit>
void for_sides(Polygon const& line, Visit const& visit) {
    for (std::size_t k = 0; k < line.size(); ++k) {
        auto const &a = line[k], &b = line[(k + 1) % line.size()];
        double const turn = std::remainder(polar_angle(b) - polar_angle(a), 2 * pi);
        visit(std::sqrt(norm2(a)), std::sqrt(norm2(b)), polar_angle(a) + turn / 2, turn);
    }
}

}  // namespace

DropOutline drop_outline(Particles<2> const& particles, Case const& c) {
    double const dx = c.particles.spacing, radius = c.surface.coverage_radius * dx;
    auto points = copy_of_positions(particles);
    Neighbours<2> neighbours(2 * radius, 0);
    neighbours.update(points);
    auto const outline = find_outline(points, neighbours, radius);

    DropOutline drop;
    for (Index const i : outline.loops[static_cast<std::size_t>(outline.largest())].particles)
        drop.line.push_back(points.view().get<Position>(static_cast<std::size_t>(i)));
    bool const is_boundary = c.fluid.surface_tension > 0 && c.surface.tension_force == "boundary";
    drop.line = is_boundary ? boundary_corners(drop.line, dx, Lattice<2>(c).volume()) : moved_out(drop.line, dx / 2);
    auto const measures = measure(drop.line);
    drop.area = measures.area;
    drop.surface_particles = outline.particles;
    drop.voids = outline.voids();
    drop.nearest = std::numeric_limits<double>::infinity();
    for (auto& x : drop.line) {
        x = x - measures.centroid;
        drop.nearest = std::min(drop.nearest, std::sqrt(norm2(x)));
        drop.farthest = std::max(drop.farthest, std::sqrt(norm2(x)));
    }
    for_sides(drop.line,
              [&](double r1, double r2, double, double turn) { drop.mean_radius += (r1 + r2) / 2 * turn / (2 * pi); });
    drop.spacing_p01 = nearest_neighbour_p01(points, neighbours) / dx;
    return drop;
}

std::complex<double> mode_of(Polygon const& line, int n) {
    // By parts, the integral is that of dr/dtheta exp(-i n theta)/(i n), which is elementary on each side.
    std::complex<double> sum = 0;
    for_sides(line, [&](double r1, double r2, double theta, double turn) {
        double const half = n * turn / 2;
        sum += (r2 - r1) * (half == 0 ? 1 : std::sin(half) / half) * std::polar(1.0, -n * theta);
    });
    return std::complex<double>(0, -1 / (pi * n)) * sum;
}

}  // namespace coronet
