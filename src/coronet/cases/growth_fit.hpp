// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The growth A exp(s t) + B exp(-s t) that is nearest to samples, by least squares: what starts at rest does not grow
// as exp(s t) at first. A and B follow from linear equations, s is searched for. The standard error follows from the
// residuals as if these were independent.

#include <optional>
#include <vector>

namespace coronet {

struct Growth {
    double rate, rate_error;  ///< s and its standard error [1/s]
};

/// Looks for s between a third of and three times `expected` [1/s]. Nothing where there are fewer than `least_growth_samples`,
/// values are not finite, or s is at an end of that range.
std::optional<Growth> fit_growth(std::vector<double> const& times, std::vector<double> const& values, double expected);
inline constexpr std::size_t least_growth_samples = 8;

}  // namespace coronet
