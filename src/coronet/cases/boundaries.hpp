// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The keys of what bounds the liquid: walls, and the box in which it is periodic.

#include "coronet/cases/case.hpp"

namespace coronet {

void describe_boundaries(Keys& keys, Case& c);

}  // namespace coronet
