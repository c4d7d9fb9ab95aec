// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/memory.hpp"

#include <fstream>
#include <string>

#include <malloc.h>

namespace coronet {

namespace {

/// A line of /proc/self/status, such as "VmRSS:", in bytes; 0 if there is none.
std::size_t status(std::string const& name) {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
        if (word != name) continue;
        std::size_t kibibytes = 0;
        file >> kibibytes;
        return 1024 * kibibytes;
    }
    return 0;
}

}  // namespace

void return_freed_memory() { mallopt(M_MMAP_THRESHOLD, 1 << 16); }

MemoryGrowth::MemoryGrowth() {
    malloc_trim(0);  // what was freed before goes back to the system, or it would be used again unseen
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;
    mark_was_reset_ = file.good();
    before_ = status("VmRSS:");
}

std::size_t MemoryGrowth::bytes() const {
    std::size_t const now = status(mark_was_reset_ ? "VmHWM:" : "VmRSS:");
    return now > before_ ? now - before_ : 0;
}

}  // namespace coronet
