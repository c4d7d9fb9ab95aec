// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

std::string trimmed(std::string const& text) {
    auto const first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string> cells_of(std::string const& line) {
    std::vector<std::string> cells;
    for (std::size_t start = 0; start <= line.size();) {
        std::size_t const end = std::min(line.find(',', start), line.size());
        cells.push_back(trimmed(line.substr(start, end - start)));
        start = end + 1;
    }
    return cells;
}

}  // namespace

Csv read_csv(std::filesystem::path const& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw CaseError(fmt::format("{}: there is no such file that can be read", file.string()));
    Csv table;
    int number = 0;
    auto const wrong = [&](std::string const& what) {
        throw CaseError(fmt::format("{}:{}: {}", file.string(), number, what));
    };
    for (std::string line; std::getline(stream, line);) {
        if (++number == 1 && line.starts_with("\xef\xbb\xbf"))
            line.erase(0, 3);  // a byte order mark, from spreadsheets
        line = trimmed(line.substr(0, line.find('#')));
        if (line.empty()) continue;
        auto const cells = cells_of(line);
        if (table.columns.empty()) {
            if (line.find_first_of(";\t") != std::string::npos)
                wrong("the columns must be parted by commas, and numbers have a decimal point");
            for (std::size_t k = 0; k < cells.size(); ++k) {
                double value = 0;
                char const* const end = cells[k].data() + cells[k].size();
                if (cells[k].empty() || std::from_chars(cells[k].data(), end, value).ptr == end)
                    wrong(fmt::format("'{}' is no name of a column: the first row must name them all", cells[k]));
                if (std::count(cells.begin(), cells.end(), cells[k]) > 1)
                    wrong(fmt::format("there are two columns '{}': leave one", cells[k]));
            }
            table.columns = cells;
            continue;
        }
        if (cells.size() != table.columns.size())
            wrong(fmt::format("{} values, but the {} columns {} need one each", cells.size(), table.columns.size(),
                              fmt::join(table.columns, ", ")));
        std::vector<double> row(cells.size());
        for (std::size_t k = 0; k < cells.size(); ++k) {
            char const* const end = cells[k].data() + cells[k].size();
            auto const [stop, error] = std::from_chars(cells[k].data(), end, row[k]);
            if (error != std::errc() || stop != end || !std::isfinite(row[k]))
                wrong(
                    fmt::format("{} is '{}', but must be a finite number such as 1.5e-3", table.columns[k], cells[k]));
        }
        table.rows.push_back(row);
        table.lines.push_back(number);
    }
    if (table.rows.empty())
        throw CaseError(
            fmt::format("{}: the table is empty: it needs a row of names and rows of numbers", file.string()));
    return table;
}

}  // namespace coronet
