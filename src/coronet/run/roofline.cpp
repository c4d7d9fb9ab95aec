// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/roofline.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <vector>

#include <unistd.h>

#include "coronet/core/pack.hpp"
#include "coronet/core/parallel.hpp"

namespace coronet {

namespace {

template <class Act>
double seconds_of(Act const& act) {
    auto const start = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Enough chains for two units that take four or five cycles each, few enough for sixteen registers.
constexpr int chains = 12;

/// Multiplies and adds `times` times in every chain. The sum of all lanes is returned, so that nothing is left out.
template <class T>
double multiply_and_add(std::int64_t times, double start) {
    Pack<T> const factor(0.999), summand(start);
    Pack<T> chain[chains];
    for (int k = 0; k < chains; ++k) chain[k] = Pack<T>(start + k);
    for (std::int64_t n = 0; n < times; ++n)
        for (int k = 0; k < chains; ++k) chain[k] = chain[k] * factor + summand;
    double total = 0;
    for (Pack<T> const& pack : chain) total += sum(pack);
    return total;
}

template <class T>
double operations_per_second() {
    auto const workers = static_cast<std::size_t>(threads());
    std::vector<double> results(workers);
    auto const try_once = [&](std::int64_t times) {
        return seconds_of([&] {
            for_blocks(workers, [&](std::size_t w) { results[w] = multiply_and_add<T>(times, 1 + results[w] * 0); });
        });
    };
    std::int64_t times = 1000;
    while (try_once(times) < 0.005) times *= 2;
    double least = try_once(times);
    for (int k = 0; k < 60; ++k) least = std::min(least, try_once(times));
    return 2.0 * chains * pack_size<T> * static_cast<double>(times) * static_cast<double>(workers) / least;
}

double bytes_per_second(std::size_t bytes) {
    // Whole numbers: their sums may be formed in any order, so the compiler takes vectors without being told.
    std::size_t const blocks = 16 * static_cast<std::size_t>(threads());
    std::size_t const block = std::max<std::size_t>(bytes / sizeof(std::uint64_t) / blocks, 1);
    auto const array = std::make_unique_for_overwrite<std::uint64_t[]>(block * blocks);
    std::vector<std::uint64_t> sums(blocks);
    for_blocks(blocks, [&](std::size_t b) { std::fill_n(array.get() + b * block, block, b); });
    double least = 1e300;
    for (int k = 0; k < 5; ++k)
        least = std::min(least, seconds_of([&] {
                             for_blocks(blocks, [&](std::size_t b) {
                                 std::uint64_t sum = sums[b];
                                 for (std::size_t i = b * block; i < (b + 1) * block; ++i) sum += array[i];
                                 sums[b] = sum;
                             });
                         }));
    return static_cast<double>(block * blocks * sizeof(std::uint64_t)) / least;
}

double operations_limit(Roof const& roof, std::string const& precision) {
    return precision == "double" ? roof.double_operations : roof.float_operations;
}

}  // namespace

double Roof::least_seconds(Work const& work, std::string const& precision) const {
    return std::max(work.operations / operations_limit(*this, precision), work.bytes / bytes);
}

bool Roof::memory_bound(Work const& work, std::string const& precision) const {
    return work.bytes / bytes > work.operations / operations_limit(*this, precision);
}

Machine this_machine() {
    Machine machine;
    machine.processor = "unknown processor";
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
            machine.processor = line.substr(line.find(": ") + 2);
            break;
        }
    machine.cores = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    machine.vector_bits = static_cast<int>(8 * sizeof(Pack<double>));
    for (int const level : {_SC_LEVEL2_CACHE_SIZE, _SC_LEVEL3_CACHE_SIZE, _SC_LEVEL4_CACHE_SIZE})
        if (long const size = sysconf(level); size > 0)
            machine.cache_bytes = std::max(machine.cache_bytes, static_cast<std::size_t>(size));
    return machine;
}

std::size_t beyond_caches() {
    std::size_t const memory =
        static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    std::size_t const wanted = std::max<std::size_t>(std::size_t{1} << 30, 4 * this_machine().cache_bytes);
    return std::min(wanted, memory / 4);
}

Roof measure_roof(int thread_count, std::size_t array_bytes) {
    set_threads(thread_count);
    Roof roof;
    roof.threads = thread_count;
    roof.double_operations = operations_per_second<double>();
    roof.float_operations = operations_per_second<float>();
    roof.bytes = bytes_per_second(array_bytes);
    return roof;
}

}  // namespace coronet
