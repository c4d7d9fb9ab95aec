// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "coronet/cases/keys.hpp"

namespace coronet {

/// The words that a key of the case allows, such as "method.gradient", in the order of the schema. The schema stays
/// their only home: who offers them elsewhere asks here.
Keys::Words choices_of(std::string const& path);

}  // namespace coronet
