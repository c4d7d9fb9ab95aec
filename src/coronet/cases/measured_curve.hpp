// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Curves over time that were measured or computed elsewhere, and how a computed one compares with them: as they stand,
// or with their times taken to be late by one number, where an experiment does not say from when it counts.

#include "coronet/cases/profile.hpp"

namespace coronet {

/// A value over time, both in the units of its table; times in order.
struct Curve {
    std::vector<double> time, value;

    /// Linear between the points, as the ends beyond them.
    double at(double t) const;
    /// The mean over [from, to]; NaN where the curve does not reach that far.
    double mean(double from, double to) const;
    /// When it first exceeds a value; NaN where it never does.
    double first_above(double value) const;
};

/// A table of cases/reference by its name; empty where there is none.
Curve builtin_curve(std::string const& name);

/// What was computed at the measured times that it reaches.
Profile beside(Curve const& computed, Curve const& measured, std::string const& name);

/// The largest of the relative differences, computed over measured less 1, at the points measured up to a time, each of
/// which is taken to be late by `late`; NaN where what is computed does not reach that far.
double largest_difference(Curve const& computed, Curve const& measured, double until, double late = 0);

/// By how much the measured times are late: the number in [-1, 1] that makes the sum of squares of those differences
/// least, for curves that rise; NaN where what is computed ends before the last point.
double fitted_lateness(Curve const& computed, Curve const& measured, double until);

}  // namespace coronet
