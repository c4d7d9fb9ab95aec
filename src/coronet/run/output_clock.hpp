// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// When something is due: at 0, every, 2 every, ... and at the end. Times are counted, not summed up, so they do not
// drift; two that differ by round-off only are the same.

#include <algorithm>
#include <cstdint>

namespace coronet {

class OutputClock {
public:
    OutputClock(double every, double end) : every_(every), end_(end) {}

    /// The next time at which output is due [s].
    double next() const {
        double const time = static_cast<double>(count_) * every_;
        return time > end_ - slack() ? end_ : time;
    }
    bool due(double time) const { return time >= next() - slack(); }
    void done(double time) {
        while (static_cast<double>(count_) * every_ <= time + slack()) ++count_;
    }

private:
    double slack() const { return 1e-9 * std::min(every_, end_); }

    double every_, end_;
    std::int64_t count_ = 0;
};

/// The step to take so that `remaining` time ends exactly with a step: no step is longer than `wanted` (but for
/// round-off), and the last two before an output are made equal rather than one of them tiny.
inline double fit_step(double wanted, double remaining) {
    if (wanted >= remaining * (1 - 1e-6)) return remaining;
    if (2 * wanted > remaining * (1 + 1e-6)) return remaining / 2;
    return wanted;
}

}  // namespace coronet
