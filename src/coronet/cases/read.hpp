// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From a case file (TOML) and --set overrides to a checked Case. Everything that is wrong is reported at once, one
// sentence a line: where, what was found, what would be right.

#include <string>
#include <string_view>
#include <vector>

#include "coronet/cases/case.hpp"

namespace coronet {

/// `text` is the file's content and `file` its name in messages; each of `settings` is "path.to.key=value".
/// Throws CaseError.
Case read_case(std::string_view text, std::string const& file, std::vector<std::string> const& settings = {});

/// The built-in case of that name, or the file at that path. Throws CaseError if there is neither.
Case load_case(std::string const& name_or_path, std::vector<std::string> const& settings = {});

/// The case as TOML with every key written out: reading it gives the same case.
std::string write_case(Case const& c);

/// The reference page of all keys, as Markdown.
std::string keys_page();

}  // namespace coronet
