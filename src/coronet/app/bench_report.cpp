// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/app/bench_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "coronet/version.hpp"

namespace coronet {

namespace {

using Row = std::vector<std::string>;

/// Columns as wide as their widest cell, aligned to the right.
std::string aligned(std::vector<Row> const& rows) {
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (Row const& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
    std::string text;
    for (Row const& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k)
            text += fmt::format("{}{:>{}}", k > 0 ? "  " : "", row[k], width[k]);
        text += '\n';
    }
    return text;
}

/// The phases of all rows, in an order that fits each of them.
std::vector<std::string> phase_names(std::vector<BenchmarkResult> const& rows) {
    std::vector<std::string> names;
    for (BenchmarkResult const& row : rows) {
        auto place = names.begin();
        for (auto const& phase : row.seconds) {
            auto const known = std::find(names.begin(), names.end(), phase.first);
            place = known == names.end() ? names.insert(place, phase.first) : known;
            ++place;
        }
    }
    return names;
}

std::string seconds_of(BenchmarkResult const& row, std::string const& name) {
    for (auto const& [phase, seconds] : row.seconds)
        if (phase == name) return fmt::format("{:.3f}", seconds);
    return "-";
}

}  // namespace

std::string BenchReport::machine_lines() const {
    std::string text =
        fmt::format("{}, {} core{}, vectors of {} bits, coronet {} ({})\n", machine.processor, machine.cores,
                    machine.cores == 1 ? "" : "s", machine.vector_bits, version, commit());
    for (Roof const& roof : roofs)
        text += fmt::format("{} thread{}: {:.1f} Gflop/s in double, {:.1f} in float; reads {:.1f} GB/s\n", roof.threads,
                            roof.threads == 1 ? "" : "s", roof.double_operations / 1e9, roof.float_operations / 1e9,
                            roof.bytes / 1e9);
    return text;
}

std::string BenchReport::table() const {
    auto const phases = phase_names(rows);
    bool const repeated = std::any_of(rows.begin(), rows.end(), [](auto const& row) { return row.setting.repeat > 1; });
    Row head{"dimension", "gradient", "precision", "threads", "particles", "neighbours", "Mevaluations/s"};
    if (repeated) head.push_back("best");
    head.insert(head.end(), {"Mpairs/s/core", "roofline", "bytes/particle", "|", "seconds:"});
    head.insert(head.end(), phases.begin(), phases.end());

    std::vector<Row> cells{head};
    for (BenchmarkResult const& row : rows) {
        auto const& setting = row.setting;
        Row line{fmt::format("{}", setting.dimension),
                 setting.gradient,
                 setting.precision,
                 fmt::format("{}", row.threads),
                 fmt::format("{}", row.particles),
                 fmt::format("{:.1f}", row.neighbours),
                 fmt::format("{:#.4g}", row.rate / 1e6)};
        if (repeated) line.push_back(fmt::format("{:#.4g}", row.best_rate() / 1e6));
        line.insert(line.end(), {fmt::format("{:#.4g}", row.pairs_per_second_per_thread() / 1e6),
                                 fmt::format("{:.1f}%", 100 * row.share_of(roofs.back())),
                                 fmt::format("{:.0f}", row.bytes_per_particle), "|", ""});
        for (std::string const& phase : phases) line.push_back(seconds_of(row, phase));
        cells.push_back(line);
    }
    return aligned(cells);
}

std::string BenchReport::json() const {
    nlohmann::ordered_json json;
    json["version"] = version;
    json["commit"] = commit();
    auto& about = json["machine"];
    about["processor"] = machine.processor;
    about["cores"] = machine.cores;
    about["vector_bits"] = machine.vector_bits;
    about["last_cache_bytes"] = machine.cache_bytes;
    auto& measured = about["roofs"] = nlohmann::ordered_json::array();
    for (Roof const& roof : roofs)
        measured.push_back({{"threads", roof.threads},
                            {"double_operations_per_second", roof.double_operations},
                            {"float_operations_per_second", roof.float_operations},
                            {"bytes_per_second", roof.bytes}});
    json["cores_used_by_others"] = other_cores;
    auto& list = json["rows"] = nlohmann::ordered_json::array();
    for (BenchmarkResult const& row : rows) {
        nlohmann::ordered_json entry{
            {"dimension", row.setting.dimension},
            {"gradient", row.setting.gradient},
            {"precision", row.setting.precision},
            {"threads", row.threads},
            {"particles", row.particles},
            {"neighbours", row.neighbours},
            {"steps", row.setting.steps},
            {"evaluations", row.evaluations},
            {"neighbour_listings", row.listings},
            {"particle_evaluations_per_second", row.rate},
            {"best_particle_evaluations_per_second", row.best_rate()},
            {"repeated_particle_evaluations_per_second", row.rates},
            {"pairs_per_second_per_core", row.pairs_per_second_per_thread()},
            {"operations_per_evaluation", row.work.operations},
            {"bytes_per_evaluation", row.work.bytes},
            {"roofline_fraction", row.share_of(roofs.back())},
            {"roofline_is_set_by",
             roofs.back().memory_bound(row.work, row.setting.precision) ? "memory" : "arithmetic"},
            {"bytes_per_particle", row.bytes_per_particle}};
        auto& seconds = entry["seconds_per_phase"] = nlohmann::ordered_json::object();
        for (auto const& [name, time] : row.seconds) seconds[name] = time;
        list.push_back(entry);
    }
    return json.dump(2) + "\n";
}

}  // namespace coronet
