// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "coronet/cases/case.hpp"

namespace coronet {

/// What no single key can tell: keys that are right each and impossible together. Throws CaseError.
void check_physics(Case const& c, std::string const& file);

}  // namespace coronet
