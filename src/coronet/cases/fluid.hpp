// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The liquid of a case. What the file states wins; what it leaves open comes from the flow curve, where one is given,
// else from the preset. After reading, every parameter of the law has its value.

#include <filesystem>

#include "coronet/cases/case.hpp"

namespace coronet {

/// Shows the keys of the section `fluid` to the visitor.
void describe_fluid(Keys& keys, Case& c);

Rheology rheology_of(Case const& c);

/// Fits what the case, read from `file`, leaves open to the table it names. Throws CaseError, with the place in the
/// table where that is wrong.
void fit_rheology(Case& c, std::string const& file);

/// A table with columns shear_rate [1/s] and either stress [Pa] or viscosity [Pa s]; others are passed by. Throws
/// CaseError.
FlowCurve read_flow_curve(std::filesystem::path const& file);

/// The table of a run: shear_rate, stress as measured, and that of the law without (`fit`) and with its bounds
/// (`as_run`).
std::string write_flow_curve(FlowCurveFit const& fit);

}  // namespace coronet
