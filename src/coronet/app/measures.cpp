// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/app/measures.hpp"

#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coronet {

std::string measures_of(std::filesystem::path const& directory) {
    std::ifstream file(directory / "summary.json");
    auto const summary = nlohmann::ordered_json::parse(file, nullptr, false);
    if (summary.is_discarded()) return "summary.json cannot be read back\n";
    std::string lines;
    auto const number = [](nlohmann::ordered_json const& measure, char const* name) {
        return measure.contains(name) && measure.at(name).is_number()
                   ? fmt::format("{:.6g}", measure.at(name).get<double>())
                   : std::string();
    };
    for (auto const& [name, measure] : summary.at("measures").items()) {
        if (measure.at("value").is_null()) {
            lines += fmt::format("{:<28} {}\n", name, measure.value("source", "not measured"));
            continue;
        }
        lines += fmt::format("{:<28} {:>13} {:>13} {:>13}\n", name, number(measure, "value"),
                             number(measure, "reference"), number(measure, "error"));
    }
    if (!lines.empty()) lines = fmt::format("{:<28} {:>13} {:>13} {:>13}\n", "", "value", "reference", "error") + lines;
    return lines;
}

}  // namespace coronet
