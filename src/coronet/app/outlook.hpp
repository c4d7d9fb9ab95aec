// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "coronet/cases/case.hpp"

namespace coronet {

/// What a valid case comes to, in lines: the liquid, its walls, and notes where a number is allowed but seldom meant
/// (no viscosity beside walls to stick to, a sound slower than ten times a fall through the liquid's height).
std::string outlook(Case const& c);

}  // namespace coronet
