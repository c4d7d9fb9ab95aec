// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The frame of another run that a case starts from: the reading of it, and what may be wrong with it.

#include <string>
#include <vector>

#include "coronet/cases/case.hpp"

namespace coronet {

/// Reads what initial.from names: the frame's liquid, of the fields pressure, velocity and volume. Throws CaseError:
/// which file, what is wrong with it and what would be right.
void read_initial_frame(Case& c, std::string const& file);

/// Whether the frame's liquid is where the particles are, of which `beyond` are too far from it to see it.
template <int D>
void check_initial_frame(Case const& c, std::size_t beyond, std::size_t particles, std::vector<std::string>& errors);

}  // namespace coronet
