// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One run: the time loop, its output and its summary. Cases describe, schemes step, this loops.

#include <filesystem>

#include "coronet/cases/case.hpp"

namespace coronet {

struct RunOptions {
    std::filesystem::path directory;  ///< where everything is written
    bool overwrite = false;           ///< whether an earlier run there may be replaced
    bool quiet = false;
};

enum class RunStatus { done, interrupted };

/// Runs a checked case. Throws CaseError if the directory cannot be used, RunError if the run fails; then, too, series,
/// summary and the frames written so far are kept.
RunStatus run_case(Case const& c, RunOptions const& options);

}  // namespace coronet
