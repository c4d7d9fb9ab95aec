// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/shells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/cases/shapes.hpp"
#include "coronet/cases/solid_harmonic.hpp"
#include "coronet/core/random.hpp"
#include "coronet/surface/frame.hpp"

namespace coronet {

namespace {

using std::numbers::pi;

/// Calls lay(x) for `count` even points of the unit circle or sphere, turned by random(seed, shell, ...).
template <class Lay>
void even_points(std::size_t count, std::uint64_t seed, std::uint64_t shell, Vector<double, 2> const&, Lay const& lay) {
    double const turn = random(seed, shell, 0);
    for (std::size_t k = 0; k < count; ++k) {
        double const angle = 2 * pi * (static_cast<double>(k) + turn) / static_cast<double>(count);
        lay(Vector<double, 2>{{std::cos(angle), std::sin(angle)}});
    }
}
template <class Lay>
void even_points(std::size_t count, std::uint64_t seed, std::uint64_t shell, Vector<double, 3> const&, Lay const& lay) {
    double const height = 2 * random(seed, shell, 0) - 1, around = 2 * pi * random(seed, shell, 1),
                 out = std::sqrt(1 - height * height), golden = pi * (3 - std::sqrt(5));
    Vector<double, 3> const pole{{out * std::cos(around), out * std::sin(around), height}};
    auto const [e1, e2] = tangents(pole);
    for (std::size_t k = 0; k < count; ++k) {
        double const z = 1 - (2 * static_cast<double>(k) + 1) / static_cast<double>(count), s = std::sqrt(1 - z * z),
                     angle = golden * static_cast<double>(k);
        lay(z * pole + s * std::cos(angle) * e1 + s * std::sin(angle) * e2);
    }
}

/// Where the potential flow of the wave takes x [radii].
template <int D>
Vector<double, D> carried(Vector<double, D> x, int n, double amplitude) {
    constexpr int steps = 20;
    double const step = amplitude / n / steps;
    for (int k = 0; k < steps; ++k) {
        auto const half = x + 0.5 * step * solid_harmonic(n, x).gradient;
        x += step * solid_harmonic(n, half).gradient;
    }
    return x;
}

}  // namespace

template <int D>
Seeds<D> fill_shells(Case const& c) {
    double const R = c.shapes.front().radius, unit = D == 2 ? pi : 4 * pi / 3, dx = c.particles.spacing;
    auto const shells = std::max(std::lround(R / dx), 1L);
    double const volume = unit * std::pow(R, D);
    auto const total = std::max(std::lround(volume / std::pow(dx, D)), 1L);
    auto const seed = static_cast<std::uint64_t>(c.particles.seed);

    Seeds<D> seeds;
    seeds.volume = volume / static_cast<double>(total);
    std::uint64_t number = 0;  // of a shell
    for (Shape const& shape : c.shapes) {
        std::size_t const before = seeds.size();
        for (long shell = 1; shell <= shells; ++shell) {
            double const outer = static_cast<double>(shell) / static_cast<double>(shells),
                         inner = static_cast<double>(shell - 1) / static_cast<double>(shells),
                         radius = std::pow((std::pow(inner, D) + std::pow(outer, D)) / 2, 1.0 / D);
            auto const within = static_cast<std::size_t>(std::lround(static_cast<double>(total) * std::pow(outer, D)));
            even_points(before + within - seeds.size(), seed, ++number, Vector<double, D>{},
                        [&](Vector<double, D> const& e) {
                            auto x = radius * e;
                            for (int k = 0; k < D; ++k)
                                x[k] += c.particles.jitter * dx / R *
                                        (2 * random(seed, seeds.size(), static_cast<std::uint64_t>(k) + 2) - 1);
                            if (shape.kind == "drop") x = carried(x, shape.mode, shape.amplitude);
                            x = turned(R * x, shape.rotation);
                            for (int k = 0; k < D; ++k) x[k] += shape.centre[k];
                            seeds.position.push_back(x);
                            seeds.surface.push_back(shell == shells);
                        });
        }
    }
    return seeds;
}

template Seeds<2> fill_shells(Case const&);
template Seeds<3> fill_shells(Case const&);

}  // namespace coronet
