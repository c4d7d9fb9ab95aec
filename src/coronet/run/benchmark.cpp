// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/benchmark.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/core/parallel.hpp"
#include "coronet/run/memory.hpp"

namespace coronet {

namespace {

using Seconds = std::vector<std::pair<std::string, double>>;

/// What has been added to each phase since `before`.
Seconds since(Seconds const& before, Seconds now) {
    for (auto& [name, seconds] : now)
        for (auto const& [known, earlier] : before)
            if (known == name) seconds -= earlier;
    return now;
}

double total(Seconds const& seconds) {
    double sum = 0;
    for (auto const& phase : seconds) sum += phase.second;
    return sum;
}

template <int D>
double exterior_share(Particles<D> const& particles) {
    if (!particles.template has<Exterior>()) return 0;
    auto const marks = particles.template get<Exterior>();
    return sum_over(particles.owned(), 0.0, [&](std::size_t i) { return marks[i]; }) /
           static_cast<double>(particles.owned());
}

/// One repetition: fills in everything but the median.
template <int D>
Seconds run_once(Case const& c, BenchmarkResult& result) {
    MemoryGrowth const memory;
    auto const scheme = make_scheme<D>(c);
    double time = 0;
    auto const step = [&] {
        scheme->begin_step(time);
        double const length = scheme->time_limit().step;
        scheme->advance(time, length);
        time += length;
    };
    step();
    Counters const counted = scheme->counters();
    Seconds const before = scheme->phases().seconds();
    for (int k = 0; k < result.setting.steps; ++k) step();
    Seconds const seconds = since(before, scheme->phases().seconds());

    auto const& particles = scheme->particles();
    double const n = static_cast<double>(particles.owned());
    result.particles = particles.owned();
    result.evaluations = scheme->counters().evaluations - counted.evaluations;
    result.listings = scheme->counters().listings - counted.listings;
    result.bytes_per_particle = std::max(result.bytes_per_particle, static_cast<double>(memory.bytes()) / n);
    result.neighbours = scheme->arrangement().neighbours_mean;
    result.work = work_per_evaluation<D>(c, result.neighbours, exterior_share(particles));
    result.rates.push_back(n * static_cast<double>(result.evaluations) / total(seconds));
    return seconds;
}

}  // namespace

Case benchmark_case(BenchmarkSetting const& s) {
    bool const flat = s.dimension == 2;
    double const volume = flat ? std::numbers::pi : 4 * std::numbers::pi / 3;
    return read_case(fmt::format("name = 'benchmark'\n"
                                 "dimension = {}\n"
                                 "[[shapes]]\n"
                                 "kind = '{}'\n"
                                 "radius = 1\n"
                                 "[particles]\n"
                                 "spacing = {}\n"
                                 "jitter = 0.1\n"
                                 "[initial]\n"
                                 "velocity = {}\n"
                                 "[fluid]\n"
                                 "density = 1000\n"
                                 "viscosity = 1\n"
                                 "sound_speed = {}\n"  // ten times the largest speed
                                 "[method]\n"
                                 "gradient = '{}'\n"
                                 "precision = '{}'\n"
                                 "viscous_force = '{}'\n"
                                 "artificial_viscosity = 0.1\n"
                                 "kernel = '{}'\n"
                                 "support = {}\n"
                                 "[time]\n"
                                 "end = 1\n",
                                 s.dimension, flat ? "disc" : "ball", std::pow(volume / s.particles, 1.0 / s.dimension),
                                 flat ? "['-x', 'y']" : "['x', 'y', '-2*z']", flat ? 10 : 20, s.gradient, s.precision,
                                 s.gradient == "sph" ? "morris" : "stress", flat ? "quintic-spline" : "wendland-c2",
                                 flat ? 3.9 : 2.6),
                     "the benchmark's case");
}

double BenchmarkResult::best_rate() const { return *std::max_element(rates.begin(), rates.end()); }

BenchmarkResult run_benchmark(BenchmarkSetting const& setting) {
    Case const c = benchmark_case(setting);
    BenchmarkResult result;
    result.setting = setting;
    result.threads = threads();
    std::vector<Seconds> all;
    for (int k = 0; k < setting.repeat; ++k)
        all.push_back(setting.dimension == 2 ? run_once<2>(c, result) : run_once<3>(c, result));

    std::vector<std::size_t> order(all.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return result.rates[a] < result.rates[b]; });
    std::size_t const median = order[(order.size() - 1) / 2];
    result.rate = result.rates[median];
    result.seconds = all[median];
    return result;
}

}  // namespace coronet
