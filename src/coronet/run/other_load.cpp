// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/other_load.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace coronet {

namespace {

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds that all cores together have worked: user, nice, system, (not idle, not waiting,) interrupts, stolen.
double busy_seconds() {
    std::ifstream file("/proc/stat");
    std::string name;
    double ticks[8] = {};
    file >> name;
    for (double& count : ticks) file >> count;
    if (!file) return 0;
    return (ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6] + ticks[7]) /
           static_cast<double>(sysconf(_SC_CLK_TCK));
}

double own_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    auto const seconds = [](timeval const& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

OtherLoad::OtherLoad() : wall_(wall_seconds()), busy_(busy_seconds()), own_(own_seconds()) {}

double OtherLoad::cores() const {
    double const others = (busy_seconds() - busy_) - (own_seconds() - own_);
    return std::max(0.0, others / (wall_seconds() - wall_));
}

}  // namespace coronet
