// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads a table of numbers: a row of names, then rows of as many numbers, all parted by commas. Blank lines and what
// follows a # are passed by.

#include <filesystem>
#include <string>
#include <vector>

namespace coronet {

struct Csv {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    std::vector<int> lines;  ///< where each row stands in the file, from 1
};

/// Throws CaseError, "file:line: what is wrong and what would be right", if the file cannot be read, a name is missing
/// or there twice, a row has too few or too many numbers, or something is not a finite number.
Csv read_csv(std::filesystem::path const& file);

}  // namespace coronet
