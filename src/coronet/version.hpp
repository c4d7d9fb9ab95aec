// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace coronet {

inline constexpr char version[] = "0.1.0";

/// The commit the program was built from, or "unknown" outside a checkout; "+" marks uncommitted changes.
std::string commit();

}  // namespace coronet
