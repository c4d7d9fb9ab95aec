// SPDX-License-Identifier: BSD-3-Clause

// What it costs to find the free surface and to fit it: nanoseconds a particle on one thread, the best of seven, for a
// block of jittered particles; without arguments.

#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <random>

#include "coronet/surface/detect.hpp"
#include "coronet/surface/reconstruct.hpp"

namespace coronet {

template <class Act>
double best_time(Act const& act) {
    double best = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < 7; ++repetition) {
        auto const start = std::chrono::steady_clock::now();
        act();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

template <int D>
void measure(std::size_t side, double support, double radius, double jitter) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> shift(-jitter, jitter);
    std::size_t count = 1;
    for (int k = 0; k < D; ++k) count *= side;
    Particles<D> particles(count);
    particles.template allocate<Position>();
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t rest = i;
        for (int k = 0; k < D; ++k, rest /= side)
            particles.template get<Position>(k)[i] = static_cast<double>(rest % side) + shift(engine);
    }
    Neighbours<D> neighbours(support, 0.05 * support);
    neighbours.update(particles);

    double const finding = best_time([&] { mark_surface(particles, neighbours, radius); });
    double found = 0;
    for (double const mark : particles.template get<Surface>()) found += mark;
    double const fitting = best_time([&] { reconstruct_surface(particles, neighbours, {2.5}); });
    fmt::print("{:9} | {:6} | {:6} | {:9} | {:7.0f} | {:25.0f} | {:20.0f}\n", D, radius, jitter, count, found,
               1e9 * finding / static_cast<double>(count), 1e9 * fitting / found);
}

}  // namespace coronet

int main() {
    coronet::set_threads(1);
    fmt::print(
        "dimension | radius | jitter | particles | surface | finding, ns per particle | fitting, ns per surface one\n");
    for (double const radius : {1.0, 1.2})
        for (double const jitter : {0.0, 0.1, 0.3}) {
            coronet::measure<2>(300, 3.5, radius, jitter);
            coronet::measure<3>(40, 2.8, radius, jitter);
        }
}
