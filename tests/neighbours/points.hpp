// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Clouds of particles to find neighbours in, and the stupid way to find them, all pairs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet::test {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int D>
using Points = std::vector<Vector<double, D>>;

template <class Check>
void in_every_dimension(Check const& check) {
    check.template operator()<1>();
    check.template operator()<2>();
    check.template operator()<3>();
}

template <int D>
Vector<double, D> along(int axis, double length) {
    Vector<double, D> x;
    x[axis] = length;
    return x;
}

/// Points between -1 and 1 along every axis, no two at one place.
template <int D>
Points<D> cloud(std::size_t count) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    Points<D> points(count);
    for (auto& x : points)
        for (double& c : x.c) c = coordinate(engine);
    return points;
}

/// Half of the points within a hundredth of the others' box.
template <int D>
Points<D> cluster(std::size_t count) {
    auto points = cloud<D>(count);
    for (std::size_t i = 0; i < count / 2; ++i) points[i] = 0.01 * points[i] + along<D>(0, 0.5);
    return points;
}

template <int D>
Points<D> lattice(int side, double spacing) {
    Points<D> points(static_cast<std::size_t>(std::pow(side, D)));
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto rest = static_cast<int>(i);
        for (double& c : points[i].c) {
            c = spacing * (rest % side);
            rest /= side;
        }
    }
    return points;
}

template <int D>
Particles<D> particles_at(Points<D> const& points) {
    Particles<D> particles(points.size());
    particles.allocate(Fields<Position, Mass>{});
    for (std::size_t i = 0; i < points.size(); ++i) {
        particles.view().template set<Position>(i, points[i]);
        particles.template get<Mass>()[i] = static_cast<double>(i);  // to be found again after a re-ordering
    }
    return particles;
}

template <int D>
Points<D> points_of(Particles<D> const& particles) {
    Points<D> points(particles.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = particles.view().template get<Position>(i);
    return points;
}

/// Adds shift(id) to the position of every particle.
template <int D, class Shift>
void move(Particles<D>& particles, Shift const& shift) {
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i)
        view.template set<Position>(i, view.template get<Position>(i) + shift(particles.id[i]));
}

/// Every pair nearer than `inner` is listed, none farther than `outer`, each once and none with itself.
template <int D>
void expect_listed(Particles<D> const& particles, Neighbours<D> const& neighbours, double inner, double outer) {
    auto const x = points_of(particles);
    for (std::size_t i = 0; i < x.size(); ++i) {
        std::vector<int> listed(x.size(), 0);
        for (Index const j : neighbours.row(i)) {
            ASSERT_GE(j, 0);
            ASSERT_LT(static_cast<std::size_t>(j), x.size());
            ++listed[static_cast<std::size_t>(j)];
        }
        ASSERT_EQ(listed[i], 0) << "particle " << i << " is its own neighbour";
        for (std::size_t j = 0; j < x.size(); ++j) {
            double const r = std::sqrt(norm2(x[i] - x[j]));
            bool const missed = listed[j] == 0 && r < inner && j != i;
            bool const wrong = listed[j] > 1 || (listed[j] == 1 && r > outer);
            ASSERT_FALSE(missed || wrong) << listed[j] << " times " << j << " in the row of " << i << ", at " << r;
        }
    }
}

/// The lists are all pairs within the reach, and none that is farther than the rounding of a float; a cell, which has a
/// number below 8 n + 64, is found with as many roundings of a double.
template <int D>
void expect_all_pairs(Particles<D> const& particles, Neighbours<D> const& neighbours, double reach) {
    double const rounding = 4 * eps * (8.0 * static_cast<double>(particles.size()) + 64);
    expect_listed(particles, neighbours, reach * (1 - rounding), reach * (1 + rounding + 0x1p-20));
}

}  // namespace coronet::test
