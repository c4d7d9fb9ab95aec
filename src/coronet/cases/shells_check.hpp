// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether particles can be laid on shells (shells.hpp, column_shells.hpp).

#include "coronet/cases/wall_check.hpp"

namespace coronet {

void check_shells(Case const& c, Errors& errors);

}  // namespace coronet
