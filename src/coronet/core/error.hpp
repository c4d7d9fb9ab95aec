// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Two ways to fail, each a sentence with the value, the unit and the way out. The program's exit status tells them
// apart.

#include <stdexcept>
#include <string>

namespace coronet {

/// The case or the command line is wrong (exit status 2): nothing has been run.
struct CaseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The run failed (exit status 3): diverged, disk full. What was written before is kept.
struct RunError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace coronet
