// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Discs and balls of particles at rest for tests of pressure operators: radius 1, density 1000, a lattice with jitter.

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "coronet/neighbours/neighbours.hpp"

namespace coronet {

template <int D>
struct Body {
    double dx;
    Particles<D> particles;
    Neighbours<D> neighbours;
    std::vector<Vector<double, D>> normals;  ///< radial; Surface marks the outermost spacing
};

/// jitter is the largest displacement along an axis, in spacings.
template <int D>
std::unique_ptr<Body<D>> body(int spacings_per_radius, double jitter, double support_in_spacings) {
    double const dx = 1.0 / spacings_per_radius;
    std::mt19937_64 engine(3);
    auto const random = [&] { return 2 * (static_cast<double>(engine() >> 11) * 0x1p-53) - 1; };
    std::vector<Vector<double, D>> x;
    int const m = spacings_per_radius;
    for (int a = -m; a < m; ++a)
        for (int b = -m; b < m; ++b)
            for (int c = D == 3 ? -m : 0; c < (D == 3 ? m : 1); ++c) {
                Vector<double, D> at{{(a + 0.5) * dx, (b + 0.5) * dx}};
                if constexpr (D == 3) at[2] = (c + 0.5) * dx;
                if (norm2(at) > 1) continue;
                for (int k = 0; k < D; ++k) at[k] += jitter * dx * random();
                x.push_back(at);
            }
    double const support = support_in_spacings * dx;
    auto made = std::unique_ptr<Body<D>>(new Body<D>{dx, Particles<D>(x.size()), {support, 0.02 * support}, {}});
    auto& particles = made->particles;
    particles.template allocate<Position, Velocity, Mass, Density, Volume, Surface>();
    auto const view = particles.view();
    double const V = std::pow(dx, D);
    for (std::size_t i = 0; i < x.size(); ++i) {
        view.template set<Position>(i, x[i]);
        view.template set<Volume>(i, V);
        view.template set<Density>(i, 1000.0);
        view.template set<Mass>(i, 1000 * V);
    }
    made->neighbours.update(particles);
    for (std::size_t i = 0; i < x.size(); ++i) {
        auto const at = view.template get<Position>(i);
        double const r = std::sqrt(norm2(at));
        made->normals.push_back((1 / r) * at);
        view.template set<Surface>(i, r > 1 - dx ? 1 : 0);
    }
    return made;
}

/// A smooth velocity that is neither linear nor free of divergence, and a common translation.
template <int D>
void set_smooth_velocity(Particles<D>& particles) {
    auto const view = particles.view();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto const x = view.template get<Position>(i);
        Vector<double, D> v{{std::sin(2 * x[1]) + x[0] + 5, std::cos(3 * x[0]) + x[1] * x[0]}};
        if constexpr (D == 3) v[2] = x[0] * x[1] + x[2];
        view.template set<Velocity>(i, v);
    }
}

inline std::vector<double> random_numbers(std::size_t count, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::vector<double> numbers(count);
    for (double& x : numbers) x = 2 * (static_cast<double>(engine() >> 11) * 0x1p-53) - 1;
    return numbers;
}

}  // namespace coronet
