// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How much memory something takes: the growth of this process's resident memory from the start of the measurement to
// its highest mark (Linux: the mark is reset through /proc/self/clear_refs). Where the mark cannot be reset, the growth
// up to now.

#include <cstddef>

namespace coronet {

class MemoryGrowth {
public:
    MemoryGrowth();
    std::size_t bytes() const;

private:
    bool mark_was_reset_ = false;
    std::size_t before_ = 0;
};

}  // namespace coronet
