// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The command `coronet bench`: options, the table on standard output, the same numbers as JSON. What is measured and
// how stands in run/benchmark.hpp and run/roofline.hpp.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace coronet {

/// Every list holds what is measured in turn; an empty one stands for the default.
struct BenchOptions {
    std::vector<int> dimensions;
    std::vector<std::string> gradients, precisions;
    std::vector<double> particles;
    int steps = 50, repeat = 1, threads = 0;
    std::string json;
};

/// Adds the command to the program, with its help.
CLI::App* add_bench(CLI::App& app, BenchOptions& options);

/// Throws CaseError for options that are wrong, RunError for a run that fails.
void bench(BenchOptions const& options);

}  // namespace coronet
