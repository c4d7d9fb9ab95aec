// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The roofline (Williams, Waterman and Patterson, Commun. ACM 52 (2009) 65): a machine that does at most P operations
// and moves at most B bytes a second needs at least max(operations/P, bytes/B) for a piece of work. P and B are
// measured: P with independent chains of multiply-adds on packs that stay in registers (a multiply-add is two
// operations), B by reading an array that no cache holds.

#include <cstddef>
#include <string>

#include "coronet/run/work.hpp"

namespace coronet {

/// What a number of threads can do at once, per second.
struct Roof {
    int threads = 1;
    double double_operations = 0, float_operations = 0;
    double bytes = 0;

    /// The least time [s] for the work; pair laws of precision "double" calculate in double, all others in float.
    double least_seconds(Work const& work, std::string const& precision) const;
    /// Whether the bytes take longer than the operations.
    bool memory_bound(Work const& work, std::string const& precision) const;
};

struct Machine {
    std::string processor;
    int cores = 0;
    int vector_bits = 0;          ///< of the packs that the pair loops use
    std::size_t cache_bytes = 0;  ///< the last level; 0 where the system does not tell
};

Machine this_machine();

/// The size of the array that is read: 1 GiB, or four times the last cache if that is more; at most a quarter of the
/// memory.
std::size_t beyond_caches();

/// Measures, with that many threads at work, in about a second; sets the number of threads. Several tries, of which the
/// best counts: what else runs on the machine can only slow it down.
Roof measure_roof(int threads, std::size_t array_bytes);

}  // namespace coronet
