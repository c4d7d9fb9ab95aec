// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The damped oscillation A exp(-b t) cos(w t + phi) + c that is nearest to samples, by least squares: the best of a
// grid of w and b, where A, phi and c follow from linear equations, then Levenberg and Marquardt. Standard errors
// follow from the residuals as if these were independent; samples much closer than a period are not, and then the
// errors are too small.

#include <optional>
#include <vector>

namespace coronet {

struct Oscillation {
    double angular_frequency, damping;              ///< w and b [1/s]
    double angular_frequency_error, damping_error;  ///< their standard errors [1/s]
    double amplitude, phase, offset;                ///< A at the first of the times, phi there [rad], c
};

/// Looks for w between half and twice `expected` [1/s]. Times [s] ascend. Nothing where the samples do not determine an
/// oscillation: fewer than `least_fit_samples`, or values that are not finite.
std::optional<Oscillation> fit_oscillation(std::vector<double> const& times, std::vector<double> const& values,
                                           double expected);
inline constexpr std::size_t least_fit_samples = 20;

}  // namespace coronet
