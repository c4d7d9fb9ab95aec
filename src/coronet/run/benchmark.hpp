// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How fast the time loop runs, measured on one case: a disc or ball of liquid with a jittered lattice in a linear
// stretching flow, v = (-x, y) or (x, y, -2 z), so that neighbours are listed anew and particles re-ordered as often as
// in a run. It is stepped exactly as a run is, without output, after one step to warm up.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "coronet/cases/case.hpp"
#include "coronet/run/roofline.hpp"

namespace coronet {

struct BenchmarkSetting {
    int dimension = 2;
    std::string gradient = "fpm", precision = "double";
    double particles = 1e5;  ///< about
    int steps = 50;
    int repeat = 1;  ///< how often all is done anew
};

struct BenchmarkResult {
    BenchmarkSetting setting;
    int threads = 1;
    std::size_t particles = 0;
    double neighbours = 0;         ///< mean inside the support, self excluded
    std::int64_t evaluations = 0;  ///< of the right-hand side
    std::int64_t listings = 0;     ///< of the neighbours
    Work work;                     ///< per particle evaluation
    double bytes_per_particle = 0;

    /// Particle evaluations per second of phases, of every repetition in turn.
    std::vector<double> rates;
    /// Seconds per phase in the repetition of median rate (the slower of two); what follows is of it, too.
    std::vector<std::pair<std::string, double>> seconds;
    double rate = 0;

    double best_rate() const;
    /// Ordered pairs inside the support, counted once per evaluation.
    double pairs_per_second_per_thread() const { return rate * neighbours / threads; }
    /// The time that the roofline allows over the time measured.
    double share_of(Roof const& roof) const { return rate * roof.least_seconds(work, setting.precision); }
};

/// The case as text that coronet run takes, read and checked. Throws CaseError.
Case benchmark_case(BenchmarkSetting const& setting);

/// Runs with the number of threads that is set. Throws CaseError, or RunError if the flow blows up.
BenchmarkResult run_benchmark(BenchmarkSetting const& setting);

}  // namespace coronet
