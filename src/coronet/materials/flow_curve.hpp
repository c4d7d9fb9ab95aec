// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A flow curve, what a rheometer measures: shear stress over shear rate; and the law of a given model that is nearest
// to it. Nearest means least sum of (ln stress of the law - ln measured stress)^2, since a rheometer errs by a share of
// what it reads, over decades. The law is fitted without its bounds and regularisation, which belong to the computation
// and not to the liquid. Logarithms of the parameters are varied, so that they stay positive, by Levenberg and
// Marquardt (Eigen's, after MINPACK), from the best points of a coarse grid: the sum has several minima.

#include <vector>

#include "coronet/materials/rheology.hpp"

namespace coronet {

struct FlowCurve {
    std::vector<double> shear_rate, stress;  ///< [1/s], [Pa], all above 0
};

struct FlowCurveFit {
    struct Parameter {
        RheologyParameter const* what;
        double relative_error;  ///< standard error over value, as the scatter of the data has it; may be infinite
    };

    FlowCurve curve;
    Rheology law;
    std::vector<Parameter> fitted;  ///< the parameters that were not given
    /// Of the law without bounds, stress over measured stress minus 1: root of the mean square, and the farthest from 0
    /// with its shear rate [1/s].
    double rms_deviation = 0, largest_deviation = 0, largest_at = 0;
};

/// Finds those physical parameters of `given.model` that are not a number in `given`, and keeps the others. Throws
/// CaseError if there are not more different shear rates than parameters to find.
FlowCurveFit fit_flow_curve(FlowCurve const& curve, Rheology const& given);

}  // namespace coronet
