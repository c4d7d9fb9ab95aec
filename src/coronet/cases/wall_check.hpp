// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What may be wrong with walls and with the probes that look at them, and the surfaces that walls read from files.

#include <string>
#include <vector>

#include <fmt/format.h>

#include "coronet/cases/case.hpp"

namespace coronet {

using Errors = std::vector<std::string>;

template <class... Parts>
void say(Errors& errors, fmt::format_string<Parts...> text, Parts&&... parts) {
    errors.push_back(fmt::format(text, std::forward<Parts>(parts)...));
}

/// Reads the surface of every wall of kind mesh. Throws CaseError: which wall, which file, what is wrong with it.
void read_surfaces(Case& c, std::string const& file);

/// Names, outlines, surfaces and motions of the case's walls.
void check_walls(Case const& c, Errors& errors);

/// The velocities of surfaces that slide, where wall particles are. Only of a case without other errors.
template <int D>
void check_sliding(Case const& c, Errors& errors);

/// Probe number k, where it looks at a wall.
void check_wall_probe(Case const& c, std::size_t k, Errors& errors);

}  // namespace coronet
