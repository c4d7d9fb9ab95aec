// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace coronet {

/// Draws the figures of a run with the Python package coronet_plot, beside other runs of the same case. The interpreter
/// is Debian's /usr/bin/python3, where matplotlib and VTK are, unless CORONET_PYTHON names another. Returns the exit
/// status.
int plot(std::string const& directory, std::vector<std::string> const& with);

}  // namespace coronet
