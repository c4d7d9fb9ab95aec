// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A CSV table written row by row, flushed at every row: whatever happens to the run, what was sampled is on disk.
// Numbers have the shortest digits that read back as the same double.

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace coronet {

class Table {
public:
    /// Creates the file with its header row. Throws RunError if it cannot.
    Table(std::filesystem::path file, std::vector<std::string> const& columns);
    /// Throws RunError if the row cannot be written (disk full).
    void row(std::span<double const> values);

private:
    void check();

    std::filesystem::path file_;
    std::ofstream stream_;
};

}  // namespace coronet
