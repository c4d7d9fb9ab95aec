// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cases that are built into the program: the TOML files of the folder cases/, embedded when it is built.

#include <span>
#include <string_view>

namespace coronet {

struct BuiltinCase {
    std::string_view name, text;
};

std::span<BuiltinCase const> builtin_cases();

}  // namespace coronet
