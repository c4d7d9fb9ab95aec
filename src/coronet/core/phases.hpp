// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where the time of a run goes: seconds summed under the name of each act.

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coronet {

class Phases {
public:
    template <class Work>
    void act(std::string_view name, Work const& work) {
        auto const start = std::chrono::steady_clock::now();
        work();
        add(name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }

    /// Names in the order of their first act, with their seconds.
    std::vector<std::pair<std::string, double>> const& seconds() const { return seconds_; }

private:
    void add(std::string_view name, double seconds) {
        for (auto& [known, total] : seconds_)
            if (known == name) {
                total += seconds;
                return;
            }
        seconds_.emplace_back(name, seconds);
    }

    std::vector<std::pair<std::string, double>> seconds_;
};

}  // namespace coronet
