// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/app/bench.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "coronet/app/bench_report.hpp"
#include "coronet/cases/choices.hpp"
#include "coronet/cases/nearest.hpp"
#include "coronet/core/error.hpp"
#include "coronet/core/parallel.hpp"
#include "coronet/io/whole_file.hpp"
#include "coronet/run/other_load.hpp"

namespace coronet {

namespace {

using Words = Keys::Words;

/// The words asked for, or the default ones where there are none. Throws CaseError for one that the case does not know.
Words chosen(std::string const& option, std::string const& key, Words const& asked, Words const& standard) {
    Words const allowed = choices_of(key);
    for (std::string const& word : asked) {
        if (std::find(allowed.begin(), allowed.end(), word) != allowed.end()) continue;
        std::string const near = nearest(word, allowed);
        throw CaseError(fmt::format("{} is '{}', but must be one of {}{}", option, word, fmt::join(allowed, ", "),
                                    near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
    return asked.empty() ? standard : asked;
}

std::vector<BenchmarkSetting> settings(BenchOptions const& options) {
    Words const gradients = chosen("--gradient", "method.gradient", options.gradients, {"sph", "fpm"});
    Words const precisions =
        chosen("--precision", "method.precision", options.precisions, choices_of("method.precision"));
    auto const dimensions = options.dimensions.empty() ? std::vector{2, 3} : options.dimensions;
    auto const sizes = options.particles.empty() ? std::vector{1e5} : options.particles;
    std::vector<BenchmarkSetting> list;
    for (int const dimension : dimensions)
        for (std::string const& gradient : gradients)
            for (std::string const& precision : precisions)
                for (double const particles : sizes)
                    list.push_back({dimension, gradient, precision, particles, options.steps, options.repeat});
    for (BenchmarkSetting const& setting : list) benchmark_case(setting);  // what is wrong with one is said at once
    return list;
}

/// A file that cannot be written is found before minutes are spent.
void try_file(std::string const& file, BenchReport const& empty) {
    try {
        write_whole(file, empty.json());
    } catch (RunError const& error) {
        throw CaseError(fmt::format("--json {}: {}", file, error.what()));
    }
}

}  // namespace

CLI::App* add_bench(CLI::App& app, BenchOptions& options) {
    auto* const command = app.add_subcommand("bench", "measure the speed of the time loop on this machine");
    auto const repeatable = [&](CLI::Option* option) { return option->take_all()->allow_extra_args(false); };
    repeatable(command->add_option("--dimension", options.dimensions, "2 or 3 (default: both)"))
        ->check(CLI::Range(2, 3));
    repeatable(command->add_option(
        "--gradient", options.gradients,
        fmt::format("one of {} (default: sph and fpm)", fmt::join(choices_of("method.gradient"), ", "))));
    repeatable(command->add_option(
        "--precision", options.precisions,
        fmt::format("one of {} (default: all of them)", fmt::join(choices_of("method.precision"), ", "))));
    repeatable(command->add_option("--particles", options.particles, "about how many (default 1e5)"))
        ->check(CLI::Range(100.0, 1e8));
    command->add_option("--steps", options.steps, "time steps that are measured, after one to warm up (default 50)")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--threads", options.threads, "how many (default: one per core)")->check(CLI::Range(1, 4096));
    command
        ->add_option("--repeat", options.repeat,
                     "measure everything so often; the table then shows the median and the best (default 1)")
        ->check(CLI::Range(1, 1000));
    command->add_option("--json", options.json, "also write all numbers to this file");
    command->footer("--dimension, --gradient, --precision and --particles may be given several times.\n");
    return command;
}

void bench(BenchOptions const& options) {
    auto const list = settings(options);
    BenchReport report;
    report.machine = this_machine();
    auto const save = [&] {
        if (!options.json.empty()) write_whole(options.json, report.json());
    };
    if (!options.json.empty()) try_file(options.json, report);

    set_threads(options.threads);
    int const thread_count = threads();
    OtherLoad const others;
    fmt::print(stderr, "measuring what the machine can do\n");
    if (thread_count > 1) report.roofs.push_back(measure_roof(1, beyond_caches()));
    report.roofs.push_back(measure_roof(thread_count, beyond_caches()));
    for (std::size_t k = 0; k < list.size(); ++k) {
        auto const& setting = list[k];
        fmt::print(stderr, "{} of {}: {}D {} {}, {:.3g} particles, {} steps{}\n", k + 1, list.size(), setting.dimension,
                   setting.gradient, setting.precision, setting.particles, setting.steps,
                   setting.repeat > 1 ? fmt::format(", {} times", setting.repeat) : "");
        report.rows.push_back(run_benchmark(setting));
        report.other_cores = others.cores();
        save();
    }
    if (report.other_cores > report.machine.cores - thread_count + 0.1)
        fmt::print(stderr,
                   "other programs kept {:.1f} cores busy meanwhile: on an idle machine the speeds are higher\n",
                   report.other_cores);
    fmt::print("{}\n{}", report.machine_lines(), report.table());
}

}  // namespace coronet
