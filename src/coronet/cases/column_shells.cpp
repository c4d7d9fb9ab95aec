// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/column_shells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coronet/core/random.hpp"

namespace coronet {

namespace {

using std::numbers::pi;
using Vector2 = Vector<double, 2>;
using Vector3 = Vector<double, 3>;

/// The square of the shortest vector of the lattice of a and b.
double shortest2(Vector2 a, Vector2 b) {
    while (true) {
        if (norm2(a) > norm2(b)) std::swap(a, b);
        double const times = dot(a, b) / norm2(a);
        if (std::fabs(times) < 0.501) return norm2(a);
        b = b - std::round(times) * a;
    }
}

/// m, for n points on a cylinder of a length and a circumference [m].
std::size_t best_turn(std::size_t n, double length, double around) {
    std::size_t best = 0;
    double farthest2 = 0;
    auto const count = static_cast<double>(n);
    for (std::size_t m = 0; m <= n / 2; ++m) {
        double const apart2 =
            shortest2({{length / count, around * static_cast<double>(m) / count}}, Vector2{{0, around}});
        if (apart2 <= farthest2) continue;
        farthest2 = apart2;
        best = m;
    }
    return best;
}

/// Where the potential flow of the wave takes x from the middle of the column.
Vector3 carried(Vector3 x, Shape const& column) {
    constexpr int steps = 20;
    double const k = 2 * pi * column.mode / column.length,
                 way = column.amplitude * column.radius / std::cyl_bessel_i(1, k * column.radius) / steps;
    auto const flow = [&](Vector3 const& at) {
        double const r = std::hypot(at[1], at[2]),
                     out = r > 0 ? std::cyl_bessel_i(1, k * r) / r * std::cos(k * at[0]) : 0;
        return Vector3{{-std::cyl_bessel_i(0, k * r) * std::sin(k * at[0]), out * at[1], out * at[2]}};
    };
    for (int step = 0; step < steps; ++step) x += way * flow(x + 0.5 * way * flow(x));
    return x;
}

}  // namespace

Seeds<3> fill_column(Case const& c) {
    Shape const& column = c.shapes.front();
    double const R = column.radius, L = column.length, dx = c.particles.spacing, volume = pi * R * R * L;
    auto const shells = std::max(std::lround(R / dx), 1L);
    auto const total = std::max(std::lround(volume / (dx * dx * dx)), shells);
    auto const seed = static_cast<std::uint64_t>(c.particles.seed);

    Seeds<3> seeds;
    seeds.volume = volume / static_cast<double>(total);
    for (long shell = 1; shell <= shells; ++shell) {
        double const outer = static_cast<double>(shell) / static_cast<double>(shells),
                     inner = static_cast<double>(shell - 1) / static_cast<double>(shells),
                     r = R * std::sqrt((inner * inner + outer * outer) / 2);
        auto const within = static_cast<std::size_t>(std::lround(static_cast<double>(total) * outer * outer)),
                   n = within - seeds.size(), m = best_turn(n, L, 2 * pi * r);
        auto const of_shell = [&](std::uint64_t which) {
            return random(seed, static_cast<std::uint64_t>(shell), which);
        };
        for (std::size_t k = 0; k < n; ++k) {
            double const along = (static_cast<double>(k) + of_shell(0)) / static_cast<double>(n),
                         angle = 2 * pi * (static_cast<double>(k * m % n) / static_cast<double>(n) + of_shell(1));
            Vector3 x{{(along - 0.5) * L, r * std::cos(angle), r * std::sin(angle)}};
            for (int a = 0; a < 3; ++a)
                x[a] +=
                    c.particles.jitter * dx * (2 * random(seed, seeds.size(), static_cast<std::uint64_t>(a) + 2) - 1);
            x = carried(x, column);
            for (int a = 0; a < 3; ++a) x[a] += column.centre[static_cast<std::size_t>(a)];
            seeds.position.push_back(x);
            seeds.surface.push_back(shell == shells);
        }
    }
    return seeds;
}

}  // namespace coronet
