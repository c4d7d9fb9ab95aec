// SPDX-License-Identifier: BSD-3-Clause

// Compares the rates that a GPU computes with those of the host, on a jittered block: prints the largest difference
// over the largest rate, for plain and corrected gradients in 2D and 3D. Exit status 77 where there is no GPU.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coronet/core/error.hpp"
#include "coronet/schemes/weakly_compressible_device.hpp"

namespace {

using namespace coronet;

template <int D>
Particles<D> block(int across) {
    std::size_t const n = static_cast<std::size_t>(std::pow(across, D) + 0.5);
    Particles<D> particles(n);
    particles.allocate(Fields<Position, Velocity, Density, Mass>{});
    auto const view = particles.view();
    for (std::size_t i = 0; i < n; ++i) {
        Vector<double, D> x, v;
        std::size_t rest = i;
        for (int k = 0; k < D; ++k, rest /= static_cast<std::size_t>(across)) {
            x[k] = (static_cast<double>(rest % across) + 0.2 * std::sin(37.0 * static_cast<double>(i) + k)) / across;
            v[k] = std::sin(3 * x[k] + k);
        }
        view.template set<Position>(i, x);
        view.template set<Velocity>(i, v);
        view.template set<Density>(i, 1000 + 5 * std::cos(4 * x[0]));
        view.template set<Mass>(i, 1000 / static_cast<double>(n));
    }
    return particles;
}

template <int D>
double difference(Gradient gradient) {
    typename WeaklyCompressible<D>::Settings s;
    int const across = D == 2 ? 60 : 20;
    s.kernel = make_kernel("wendland-c2", D, 2.6 / across);
    s.skin = 0.3 / across;
    s.gradient = gradient;
    s.liquid.rheology.viscosity = 0.1;
    WeaklyCompressible<D> host(s, block<D>(across));
    host.evaluate(0);

    // The host's particles, with their rates; a second copy of the same state gets the device's rates.
    WeaklyCompressible<D> there(s, block<D>(across));
    there.evaluate(0);
    auto& particles = const_cast<Particles<D>&>(there.particles());
    Neighbours<D> neighbours(s.kernel.support, s.skin);
    neighbours.update(particles);
    for (int k = 0; k < D; ++k) std::ranges::fill(particles.template get<Acceleration>(k), NAN);
    rates_on_device<D>(s, particles, neighbours);

    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < particles.owned(); ++i)
        for (int k = 0; k < D; ++k) {
            double const a = host.particles().template get<Acceleration>(k)[i];
            double const apart = std::fabs(a - particles.template get<Acceleration>(k)[i]);
            if (!(apart <= worst)) worst = apart;
            largest = std::max(largest, std::fabs(a));
        }
    return worst / largest;
}

}  // namespace

int main() {
    try {
        fmt::print("2D sph {:.2e}  2D fpm {:.2e}  3D sph {:.2e}  3D fpm {:.2e}\n", difference<2>(Gradient::sph),
                   difference<2>(Gradient::fpm), difference<3>(Gradient::sph), difference<3>(Gradient::fpm));
    } catch (coronet::RunError const& error) {
        fmt::print("{}\n", error.what());
        return 77;
    }
}
