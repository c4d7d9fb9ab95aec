// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "coronet/cases/shapes.hpp"

namespace coronet {

namespace {

template <int D>
struct Lattice {
    Matrix<double, D> basis;  // columns, in spacings
    double cell;              // volume of a cell, in spacings^D
    std::vector<std::array<int, D>> nearest;
};

template <int D>
Lattice<D> lattice(std::string const& kind) {
    Lattice<D> l;
    auto const add = [&](std::array<int, D> n) {
        l.nearest.push_back(n);
        for (int& k : n) k = -k;
        l.nearest.push_back(n);
    };
    for (int k = 0; k < D; ++k) {
        std::array<int, D> n{};
        n[k] = 1;
        add(n);
    }
    if (kind == "square") {
        l.basis = identity<double, D>();
    } else if constexpr (D == 2) {
        l.basis = {{1, 0.5, 0, std::sqrt(0.75)}};
        add({1, -1});
    } else {
        double const s = std::sqrt(0.5);  // face-centred cubic: (1,1,0), (1,0,1), (0,1,1) over the root of two
        l.basis = {{s, s, 0, s, 0, s, 0, s, s}};
        add({1, -1, 0});
        add({1, 0, -1});
        add({0, 1, -1});
    }
    l.cell = std::fabs(determinant(l.basis));
    return l;
}

/// A number in [0, 1) that depends on the three integers alone (splitmix64), so it is the same everywhere.
double random(std::uint64_t seed, std::uint64_t particle, std::uint64_t axis) {
    std::uint64_t z = seed * 0x9E3779B97F4A7C15u + particle * 0xD1B54A32D192ED03u + axis * 0x8CB92BA72F3D8DD7u;
    for (int round = 0; round < 2; ++round) {
        z += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        z ^= z >> 31;
    }
    return static_cast<double>(z >> 11) * 0x1p-53;
}

}  // namespace

template <int D>
double expected_particles(Case const& c) {
    double const cell = lattice<D>(c.particles.lattice).cell * std::pow(c.particles.spacing, D);
    double count = 0;
    for (Shape const& shape : c.shapes) {
        auto const half = half_extents<D>(shape);
        double box = 1;
        for (int k = 0; k < D; ++k) box *= 2 * half[k];
        count += box / cell;
    }
    return count;
}

template <int D>
Seeds<D> fill(Case const& c) {
    double const dx = c.particles.spacing, slack = 1e-9 * dx;
    auto const l = lattice<D>(c.particles.lattice);
    double const offset = c.particles.origin == "cell" ? 0.5 : 0;
    auto const place = [&](std::array<int, D> const& n) {
        Vector<double, D> in_cells;
        for (int k = 0; k < D; ++k) in_cells[k] = n[k] + offset;
        return turned(dx * (l.basis * in_cells), c.particles.rotation);
    };
    auto const inside = [&](Vector<double, D> const& x) {
        return std::any_of(c.shapes.begin(), c.shapes.end(), [&](Shape const& s) { return holds(s, x, slack); });
    };

    Seeds<D> seeds;
    seeds.volume = l.cell * std::pow(dx, D);
    auto const lay = [&](std::array<int, D> const& n, Vector<double, D> x) {
        bool const surface = std::any_of(l.nearest.begin(), l.nearest.end(), [&](std::array<int, D> const& step) {
            auto beside = n;
            for (int k = 0; k < D; ++k) beside[k] += step[k];
            return !inside(place(beside));
        });
        auto const seed = static_cast<std::uint64_t>(c.particles.seed);
        for (int k = 0; k < D; ++k)
            x[k] += c.particles.jitter * dx * (2 * random(seed, seeds.size(), static_cast<std::uint64_t>(k)) - 1);
        seeds.position.push_back(x);
        seeds.surface.push_back(surface);
    };

    // Shape after shape; a point that an earlier shape holds, too, has its particle already.
    auto const inverse = (1 / determinant(l.basis)) * adjugate(l.basis);
    for (Shape const& shape : c.shapes) {
        Vector<double, D> centre;
        for (int k = 0; k < D; ++k) centre[k] = shape.centre[k];
        auto const middle = inverse * turned((1 / dx) * centre, -c.particles.rotation);
        std::array<int, D> low, high;
        for (int k = 0; k < D; ++k) {
            Vector<double, D> row;  // of the inverse basis: the direction in which the lattice index k grows
            for (int m = 0; m < D; ++m) row[m] = inverse(k, m);
            double const half = extent(shape, turned(row, c.particles.rotation - shape.rotation)) / dx + 2;
            low[k] = static_cast<int>(std::floor(middle[k] - half));
            high[k] = static_cast<int>(std::ceil(middle[k] + half));
        }
        auto const new_here = [&](Vector<double, D> const& x) {
            return holds(shape, x, slack) && std::none_of(c.shapes.data(), &shape, [&](Shape const& earlier) {
                       return holds(earlier, x, slack);
                   });
        };
        std::array<int, D> n = low;
        for (bool more = true; more;) {
            if (auto const x = place(n); new_here(x)) lay(n, x);
            more = false;
            for (int k = 0; k < D && !more; ++k) {
                more = ++n[k] <= high[k];
                if (!more) n[k] = low[k];
            }
        }
    }
    return seeds;
}

template Seeds<2> fill(Case const&);
template Seeds<3> fill(Case const&);
template double expected_particles<2>(Case const&);
template double expected_particles<3>(Case const&);

}  // namespace coronet
