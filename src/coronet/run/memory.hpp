// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How much memory something takes: the growth of this process's resident memory from the start of the measurement to
// its highest mark (Linux: the mark is reset through /proc/self/clear_refs). Where the mark cannot be reset, the growth
// up to now.

#include <cstddef>

namespace coronet {

/// Large arrays, rows of neighbours among them, go back to the system when they are freed, for as long as the program
/// runs: else holes of changing sizes pile up between them, a tenth of the memory of a run.
void return_freed_memory();

class MemoryGrowth {
public:
    MemoryGrowth();
    std::size_t bytes() const;

private:
    bool mark_was_reset_ = false;
    std::size_t before_ = 0;
};

}  // namespace coronet
