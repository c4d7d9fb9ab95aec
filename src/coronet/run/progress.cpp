// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/progress.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace coronet {

namespace {

std::string readable(double seconds) {
    if (seconds < 60) return fmt::format("{:.0f} s", seconds);
    if (seconds < 3600) return fmt::format("{:.0f} min {:02.0f} s", std::floor(seconds / 60), std::fmod(seconds, 60));
    return fmt::format("{:.0f} h {:02.0f} min", std::floor(seconds / 3600), std::floor(std::fmod(seconds, 3600) / 60));
}

}  // namespace

Progress::Progress(bool quiet, double end, std::size_t particles)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), end_(end), particles_(particles) {}

Progress::~Progress() { end_line(); }

void Progress::end_line() {
    if (open_line_) std::fputc('\n', stderr);
    open_line_ = false;
}

void Progress::show(double time, std::int64_t steps, bool last) {
    if (quiet_) return;
    auto const now = Clock::now();
    if (!last && now - shown_ < std::chrono::duration<double>(terminal_ ? 0.2 : 5.0)) return;
    shown_ = now;
    double const wall = std::chrono::duration<double>(now - start_).count(), share = time / end_;
    double const speed = static_cast<double>(steps) / wall;
    std::string const line =
        fmt::format("t = {:.6g} s  {:5.1f} %  {:.3g} steps/s  {:.3g} particle-steps/s  {} left", time, 100 * share,
                    speed, speed * static_cast<double>(particles_), share > 0 ? readable(wall / share - wall) : "?");
    if (terminal_) fmt::print(stderr, "\r{:<100}", line);
    else fmt::print(stderr, "{}\n", line);
    std::fflush(stderr);
    open_line_ = terminal_;
}

}  // namespace coronet
