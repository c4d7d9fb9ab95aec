// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a run has measured, beside what it should be, for whoever sits before it: a line for each measure of
// summary.json.

#include <filesystem>
#include <string>

namespace coronet {

/// The lines, empty where there are none; a measure that could not be taken says why.
std::string measures_of(std::filesystem::path const& directory);

}  // namespace coronet
