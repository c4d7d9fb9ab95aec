// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

/// The hundredth part of the particles have a neighbour nearer than that [m].
double nearest_neighbour_p01(Particles<2> const& particles, Neighbours<2> const& neighbours) {
    auto const view = particles.view();
    std::vector<double> nearest(particles.owned(), neighbours.support());
    for_each(nearest.size(), [&](std::size_t i) {
        for (Index const j : neighbours.row(i)) {
            double const r = std::sqrt(norm2(view.get<Position>(static_cast<std::size_t>(j)) - view.get<Position>(i)));
            nearest[i] = std::min(nearest[i], r);
        }
    });
    auto const hundredth = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 100);
    std::nth_element(nearest.begin(), hundredth, nearest.end());
    return *hundredth;
}

}  // namespace

DropOutline drop_outline(Particles<2> const& particles, Case const& c) {
    double const dx = c.particles.spacing, radius = c.surface.coverage_radius * dx;
    Particles<2> points(particles.owned());  // a copy, which a listing may re-order
    points.allocate(Fields<Position>{});
    for_each(points.owned(), [&](std::size_t i) { points.view().set<Position>(i, particles.view().get<Position>(i)); });
    Neighbours<2> neighbours(2 * radius, 0);
    neighbours.update(points);
    auto const outline = find_outline(points, neighbours, radius);

    DropOutline drop;
    for (Index const i : outline.loops[static_cast<std::size_t>(outline.largest())].particles)
        drop.line.push_back(points.view().get<Position>(static_cast<std::size_t>(i)));
    drop.line = moved_out(drop.line, dx / 2);
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
