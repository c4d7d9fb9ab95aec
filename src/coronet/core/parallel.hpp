// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The only doors to threads that compute: a loop over blocks of work, and a sum over items in fixed blocks. Both give
// the same bits for any number of threads: a block's work never depends on who does it, and partial sums are added in
// block order.

#include <algorithm>
#include <cstddef>
#include <exception>
#include <vector>

namespace coronet {

/// How many threads the loops use; 0 asks for OpenMP's own choice: OMP_NUM_THREADS, or else one per core.
void set_threads(int threads);
int threads();

/// How the next loop deals its blocks. Many go to the threads in equal runs, so that a thread finds in its cache what
/// it wrote in the loop before; few go to whoever is free, for they differ in length.
void deal_blocks(std::size_t blocks);

/// Calls work(block) for block = 0 ... blocks - 1, each once, on any thread. What the work throws (memory may run out)
/// leaves the loop when all blocks have ended.
template <class Work>
void for_blocks(std::size_t blocks, Work const& work) {
    std::exception_ptr failure;
    deal_blocks(blocks);
    // A single block is no work for several threads: waking them takes longer than many a small loop.
#pragma omp parallel for schedule(runtime) if (blocks > 1)
    for (std::size_t block = 0; block < blocks; ++block) {
        try {
            work(block);
        } catch (...) {
#pragma omp critical
            failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
}

inline constexpr std::size_t items_per_block = 512;

/// Calls work(first, last) for consecutive ranges that cover [0, items).
template <class Work>
void for_ranges(std::size_t items, Work const& work) {
    for_blocks((items + items_per_block - 1) / items_per_block, [&](std::size_t block) {
        std::size_t const first = block * items_per_block;
        work(first, std::min(items, first + items_per_block));
    });
}

/// Calls work(item) for item = 0 ... items - 1.
template <class Work>
void for_each(std::size_t items, Work const& work) {
    for_ranges(items, [&](std::size_t first, std::size_t last) {
        for (std::size_t item = first; item < last; ++item) work(item);
    });
}

/// Folds part(item) over all items, starting from `nothing`: first inside fixed blocks, then over the blocks in order.
template <class T, class Part, class Fold>
T fold(std::size_t items, T const& nothing, Part const& part, Fold const& join) {
    std::vector<T> blocks((items + items_per_block - 1) / items_per_block, nothing);
    for_ranges(items, [&](std::size_t first, std::size_t last) {
        T partial = nothing;
        for (std::size_t item = first; item < last; ++item) partial = join(partial, part(item));
        blocks[first / items_per_block] = partial;
    });
    T whole = nothing;
    for (T const& block : blocks) whole = join(whole, block);
    return whole;
}

template <class T, class Part>
T sum_over(std::size_t items, T const& zero, Part const& part) {
    return fold(items, zero, part, [](T const& a, T const& b) { return a + b; });
}

template <class Part>
double max_over(std::size_t items, double least, Part const& part) {
    return fold(items, least, part, [](double a, double b) { return a < b ? b : a; });
}

template <class Part>
double min_over(std::size_t items, double most, Part const& part) {
    return fold(items, most, part, [](double a, double b) { return b < a ? b : a; });
}

}  // namespace coronet
