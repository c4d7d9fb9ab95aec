// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coronet {

namespace {

/// The root of sum (a - b)^2 over sum b^2.
double difference(std::vector<double> const& a, std::vector<double> const& b) {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < b.size(); ++k) {
        sum += (a[k] - b[k]) * (a[k] - b[k]);
        size += b[k] * b[k];
    }
    return sum > 0 ? std::sqrt(sum / size) : 0;
}

}  // namespace

double relative_error(Profile const& profile) { return difference(profile.computed, profile.reference); }

double Settling::change(double time, std::vector<Profile> const& profiles) {
    double largest = std::numeric_limits<double>::infinity();
    // The newest that is old enough is kept, and all after it.
    auto const is_old = [&](auto const& entry) { return entry.first <= 0.8 * time; };
    auto const young = std::find_if_not(before_.begin(), before_.end(), is_old);
    if (young != before_.begin()) {
        before_.erase(before_.begin(), young - 1);
        largest = 0;
        auto const& old = before_.front().second;
        for (std::size_t k = 0; k < profiles.size(); ++k)
            largest = std::max(largest, difference(old[k].computed, profiles[k].computed));
    }
    before_.emplace_back(time, profiles);
    return time > 0 ? largest : std::numeric_limits<double>::infinity();
}

}  // namespace coronet
