// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is embedded in the program when it is built: the TOML files of the folder cases/, and those tables of
// cases/reference/ that probes compare with.

#include <span>
#include <string_view>

namespace coronet {

struct BuiltinFile {
    std::string_view name, text;
};

std::span<BuiltinFile const> builtin_cases();
std::span<BuiltinFile const> builtin_tables();

}  // namespace coronet
