// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a benchmark found, in words: the lines on the machine, the table with one row per configuration, and all of it
// as JSON, with all digits and the units in the names of the keys.

#include <string>
#include <vector>

#include "coronet/run/benchmark.hpp"

namespace coronet {

struct BenchReport {
    Machine machine;
    std::vector<Roof> roofs;  ///< of one thread, and of the threads that the rows were measured with, which stand last
    std::vector<BenchmarkResult> rows;
    double other_cores = 0;  ///< how many cores other programs kept busy meanwhile

    std::string machine_lines() const;
    std::string table() const;
    std::string json() const;
};

}  // namespace coronet
