// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The keys of probes: which kinds there are, and what each wants.

#include "coronet/cases/case.hpp"

namespace coronet {

void describe_probe(Keys& keys, ProbeKeys& probe, std::string const& path, int dimension);

}  // namespace coronet
