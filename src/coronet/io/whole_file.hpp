// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace coronet {

/// Writes a file whole: beside its place, then renamed into it, so that a crash or a full disk never leaves half of it.
/// Throws RunError with the system's reason.
void write_whole(std::filesystem::path const& file, std::string const& content);

}  // namespace coronet
