// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pair forces that a case may add to those every scheme has: to add one, name it here. A term that has coefficients
// describes them as keys of the case (see CONTRIBUTING.md); the schema and the schemes take everything else from this
// list.

#include "coronet/pairs/law.hpp"
#include "coronet/terms/artificial_viscosity.hpp"

namespace coronet {

using PairTerms = Sum<ArtificialViscosity>;

}  // namespace coronet
