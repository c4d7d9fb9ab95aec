// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The progress line on standard error: simulated time, percent, steps/s, particle-steps/s, time left. On a terminal it
// rewrites itself; elsewhere it is a plain line every few seconds.

#include <chrono>
#include <cstdint>

namespace coronet {

class Progress {
public:
    Progress(bool quiet, double end, std::size_t particles);
    ~Progress();
    void show(double time, std::int64_t steps, bool last = false);
    /// Before something else is printed.
    void end_line();

private:
    using Clock = std::chrono::steady_clock;
    bool quiet_, terminal_, open_line_ = false;
    double end_;
    std::size_t particles_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
};

}  // namespace coronet
