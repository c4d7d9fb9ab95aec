// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What may be wrong with a rheology, beyond the range of each of its numbers.

#include "coronet/cases/wall_check.hpp"

namespace coronet {

void check_rheology(Case const& c, Errors& errors);

}  // namespace coronet
