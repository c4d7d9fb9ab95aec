// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/measured_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "coronet/cases/builtin.hpp"

namespace coronet {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double Curve::at(double t) const {
    auto const after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    if (after == 0) return value.front();
    if (after == time.size()) return value.back();
    double const share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return value[after - 1] + share * (value[after] - value[after - 1]);
}

double Curve::mean(double from, double to) const {
    if (time.empty() || time.front() > from || time.back() < to) return nan;
    double sum = 0, t = from, v = at(from);
    auto const go = [&](double next, double value_there) {
        sum += (next - t) * (v + value_there) / 2;
        t = next;
        v = value_there;
    };
    for (std::size_t k = 0; k < time.size(); ++k)
        if (time[k] > from && time[k] < to) go(time[k], value[k]);
    go(to, at(to));
    return sum / (to - from);
}

double Curve::first_above(double least) const {
    for (std::size_t k = 0; k < time.size(); ++k)
        if (value[k] > least) return time[k];
    return nan;
}

Curve builtin_curve(std::string const& name) {
    Curve curve;
    for (BuiltinFile const& table : builtin_tables()) {
        if (table.name != name) continue;
        std::istringstream lines{std::string(table.text)};
        for (std::string line; std::getline(lines, line);) {
            double t = 0, v = 0;
            char comma = 0;
            if (!(std::istringstream(line) >> t >> comma >> v)) continue;  // comments and the names of the columns
            curve.time.push_back(t);
            curve.value.push_back(v);
        }
    }
    return curve;
}

Profile beside(Curve const& computed, Curve const& measured, std::string const& name) {
    Profile profile{name, {}, {}, {}};
    for (std::size_t k = 0; k < measured.time.size(); ++k) {
        if (computed.time.empty() || measured.time[k] > computed.time.back()) break;
        profile.position.push_back(measured.time[k]);
        profile.computed.push_back(computed.at(measured.time[k]));
        profile.reference.push_back(measured.value[k]);
    }
    return profile;
}

double largest_difference(Curve const& computed, Curve const& measured, double until, double late) {
    double largest = 0;
    for (std::size_t k = 0; k < measured.time.size() && measured.time[k] <= until; ++k) {
        double const t = measured.time[k] - late;
        if (computed.time.empty() || t > computed.time.back()) return nan;
        double const difference = computed.at(t) / measured.value[k] - 1;
        if (std::fabs(difference) > std::fabs(largest)) largest = difference;
    }
    return largest;
}

double fitted_lateness(Curve const& computed, Curve const& measured, double until) {
    if (std::isnan(largest_difference(computed, measured, until))) return nan;
    auto const misfit = [&](double late) {
        double sum = 0;
        for (std::size_t k = 0; k < measured.time.size() && measured.time[k] <= until; ++k)
            sum += std::pow(computed.at(measured.time[k] - late) / measured.value[k] - 1, 2);
        return sum;
    };
    double const golden = (std::sqrt(5.0) - 1) / 2;  // the bracket shrinks by this a step
    double low = -1, high = 1;
    while (high - low > 1e-4) {
        double const left = high - golden * (high - low), right = low + golden * (high - low);
        if (misfit(left) < misfit(right)) high = right;
        else low = left;
    }
    return (low + high) / 2;
}

}  // namespace coronet
