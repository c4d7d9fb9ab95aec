// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/core/error.hpp"

namespace coronet {

Table::Table(std::filesystem::path file, std::vector<std::string> const& columns)
    : file_(std::move(file)), stream_(file_) {
    stream_ << fmt::format("{}\n", fmt::join(columns, ","));
    check();
}

void Table::row(std::span<double const> values) {
    stream_ << fmt::format("{}\n", fmt::join(values, ","));
    check();
}

void Table::check() {
    stream_.flush();
    if (!stream_) throw RunError(fmt::format("{} cannot be written: is the disk full?", file_.string()));
}

}  // namespace coronet
