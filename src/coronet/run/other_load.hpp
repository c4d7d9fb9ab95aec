// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How many cores other programs kept busy while something was measured (Linux, /proc/stat): a measurement that shared
// its cores is too slow, and nothing in its own numbers says so.

namespace coronet {

class OtherLoad {
public:
    OtherLoad();
    /// Mean number of cores since the start of the measurement; 0 where the system does not tell.
    double cores() const;

private:
    double wall_, busy_, own_;  // at the start [s]
};

}  // namespace coronet
