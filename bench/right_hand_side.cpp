// SPDX-License-Identifier: BSD-3-Clause

// Evaluations of the right-hand side (both sweeps and the state) on a jittered block of liquid: particles and ordered
// pairs inside the support per second, for plain and corrected gradients, 2D and 3D, 1e4 to 1e6 particles, 1 and 2
// threads.
//     build/release/right_hand_side [--benchmark_filter=...]

#include <benchmark/benchmark.h>

#include <cmath>

#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/core/parallel.hpp"

namespace {

using namespace coronet;

template <int D>
std::unique_ptr<Scheme<D>> block(std::string const& gradient, double particles) {
    double const spacing = std::pow(particles, -1.0 / D);
    std::string const zeros = D == 2 ? "[0, 0]" : "[0, 0, 0]", ones = D == 2 ? "[1, 1]" : "[1, 1, 1]";
    return make_scheme<D>(
        read_case("name = 'block'\ndimension = " + std::to_string(D) + "\n[[shapes]]\nkind = 'box'\nsize = " + ones +
                      "\n[particles]\njitter = 0.1\norigin = 'cell'\nspacing = " + std::to_string(spacing) +
                      "\n[fluid]\ndensity = 1000\nviscosity = 1\nsound_speed = 10\n[method]\ngradient = '" + gradient +
                      (D == 2 ? "'" : "'\nkernel = 'wendland-c2'\nsupport = 2.6") + "\n[initial]\nvelocity = " + zeros +
                      "\n[time]\nend = 1\n",
                  "block"));
}

template <int D>
void evaluations(benchmark::State& state, std::string const& gradient) {
    set_threads(static_cast<int>(state.range(1)));
    auto const scheme = block<D>(gradient, static_cast<double>(state.range(0)));
    scheme->begin_step(0);
    for (auto _ : state) scheme->begin_step(0);
    double const particles = static_cast<double>(scheme->particles().owned());
    double const neighbours = scheme->arrangement().neighbours_mean;
    double const evaluated = static_cast<double>(state.iterations()) * particles;
    state.counters["particles/s"] = benchmark::Counter(evaluated, benchmark::Counter::kIsRate);
    state.counters["pairs/s"] = benchmark::Counter(evaluated * neighbours, benchmark::Counter::kIsRate);
    state.counters["neighbours"] = neighbours;
}

}  // namespace

int main(int argc, char** argv) {
    for (std::string const gradient : {"sph", "fpm"})
        for (int const dimension : {2, 3})
            benchmark::RegisterBenchmark((std::to_string(dimension) + "D_" + gradient).c_str(),
                                         dimension == 2 ? evaluations<2> : evaluations<3>, gradient)
                ->ArgNames({"particles", "threads"})
                ->ArgsProduct({{10000, 100000, 1000000}, {1, 2}})
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
