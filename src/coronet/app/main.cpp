// SPDX-License-Identifier: BSD-3-Clause

// The program: its commands, its messages and its exit status (0 done, 2 wrong case or command line, 3 failed run,
// 130 interrupted).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include "coronet/app/bench.hpp"
#include "coronet/app/measures.hpp"
#include "coronet/app/outlook.hpp"
#include "coronet/app/plot.hpp"
#include "coronet/cases/builtin.hpp"
#include "coronet/cases/nearest.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/core/error.hpp"
#include "coronet/core/parallel.hpp"
#include "coronet/io/frame.hpp"
#include "coronet/run/memory.hpp"
#include "coronet/run/run.hpp"
#include "coronet/version.hpp"

namespace coronet {

namespace {

constexpr int done = 0, wrong_case = 2, failed_run = 3, interrupted_run = 130;

void list_cases() {
    for (BuiltinFile const& known : builtin_cases()) {
        Case const c = load_case(std::string(known.name));
        fmt::print("{:<22} {}D  {}\n", known.name, c.dimension, c.title);
    }
}

/// How well the law of a case fits its flow curve.
void show_fit(Case const& c) {
    FlowCurveFit const& fit = *c.flow_curve_fit;
    auto const& rates = fit.curve.shear_rate;
    auto const [slow, fast] = std::minmax_element(rates.begin(), rates.end());
    fmt::print(
        "{} beside {} points of {}, {:.4g} to {:.4g} 1/s: deviation {:.3g} % rms, at most {:.3g} % (at {:.4g} 1/s)\n",
        c.fluid.rheology, rates.size(), c.fluid.flow_curve, *slow, *fast, 100 * fit.rms_deviation,
        100 * std::fabs(fit.largest_deviation), fit.largest_at);
    for (RheologyParameter const& parameter : rheology_parameters()) {
        if (!parameter.physical || !parameter.used_by(fit.law.model)) continue;
        auto const found = std::find_if(fit.fitted.begin(), fit.fitted.end(),
                                        [&](auto const& fitted) { return fitted.what == &parameter; });
        fmt::print("  {:<24} = {:.5g} {}", parameter.name, fit.law.*parameter.value,
                   parameter.unit == "-" ? "" : parameter.unit + " ");
        if (found == fit.fitted.end()) fmt::print("(as stated)\n");
        else if (found->relative_error < 1) fmt::print("(fitted, +- {:.2g} %)\n", 100 * found->relative_error);
        else fmt::print("(fitted, but the table does not determine it)\n");
    }
}

/// What a case starts from.
template <int D>
void show_initial_frame(Case const& c) {
    Frame const& frame = *c.initial.frame;
    fmt::print(
        "velocity and pressure at the start are those of {}, not the case's formulas: its {} particles at {:.6g} s\n",
        c.initial.from, frame.ids.size(), frame.time);
    if (auto const beyond = initial_state(c, fill<D>(c), WallSeeds<D>{}).beyond; beyond > 0)
        fmt::print("  {} particles are too far from its liquid to see it and take the values of its nearest\n", beyond);
}

void check(std::string const& name, std::vector<std::string> const& settings) {
    Case const c = load_case(name, settings);
    fmt::print("{}", outlook(c));
    if (c.flow_curve_fit) show_fit(c);
    if (c.initial.frame) c.dimension == 2 ? show_initial_frame<2>(c) : show_initial_frame<3>(c);
}

int run(std::string const& name, std::vector<std::string> const& settings, RunOptions options, int thread_count) {
    Case const c = load_case(name, settings);
    if (options.directory.empty()) options.directory = std::filesystem::path("runs") / c.name;
    set_threads(thread_count);
    RunStatus const status = run_case(c, options);
    if (!options.quiet) fmt::print(stderr, "{}", measures_of(options.directory));
    fmt::print("{}\n", options.directory.string());
    return status == RunStatus::done ? done : interrupted_run;
}

/// GNU's OpenMP lets idle threads spin for long, which slows a run tenfold where the cores are shared. It reads the
/// count when it is loaded, so the program sets a short one and starts itself anew.
void let_idle_threads_sleep(char** argv) {
    if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
    setenv("GOMP_SPINCOUNT", "1000", 1);
    execv("/proc/self/exe", argv);  // returns only where it fails: then threads spin
}

int start(int argc, char** argv) {
    CLI::App app{"coronet: droplets, splashes and viscous free-surface flows by smoothed particle hydrodynamics"};
    app.set_version_flag("--version", fmt::format("coronet {} ({})", version, commit()));
    app.require_subcommand(1);

    std::string name, directory;
    std::vector<std::string> settings, with;
    int thread_count = 0;
    RunOptions options;
    auto const add_case = [&](CLI::App* command) {
        command->add_option("CASE", name, "a .toml file, or the name of a built-in case")->required();
        command->add_option("--set", settings, "change a key of the case: path.to.key=value, as often as you like")
            ->take_all()
            ->allow_extra_args(false);
    };

    auto* const run_command = app.add_subcommand("run", "run a case");
    add_case(run_command);
    run_command->add_option("--out", directory, "where to write (default runs/<case>)");
    run_command->add_flag("--overwrite", options.overwrite, "replace a run that is already there");
    run_command->add_option("--threads", thread_count, "how many (default: one per core)")->check(CLI::Range(1, 4096));
    run_command->add_flag("--quiet", options.quiet, "show neither progress nor measures");
    auto* const cases_command = app.add_subcommand("cases", "list the built-in cases");
    auto* const check_command = app.add_subcommand("check", "check a case without running it");
    add_case(check_command);
    auto* const keys_command = app.add_subcommand("keys", "print the reference page of all keys of a case (Markdown)");
    auto* const plot_command = app.add_subcommand("plot", "draw the figures of a run into DIR/figures");
    plot_command->add_option("DIR", directory, "the directory of a run")->required();
    plot_command->add_option("--with", with, "other runs of the same case to draw beside it");
    BenchOptions bench_options;
    auto* const bench_command = add_bench(app, bench_options);

    std::vector<std::string> commands;
    for (auto* command : app.get_subcommands([](CLI::App*) { return true; })) commands.push_back(command->get_name());
    if (argc > 1 && argv[1][0] != '-' && std::find(commands.begin(), commands.end(), argv[1]) == commands.end()) {
        std::string const near = nearest(argv[1], commands);
        std::string const meant = near.empty() ? "" : " (did you mean " + near + "?)";
        throw CaseError(
            fmt::format("there is no command '{}'{}; there are {}", argv[1], meant, fmt::join(commands, ", ")));
    }
    try {
        app.parse(argc, argv);
    } catch (CLI::ParseError const& error) {
        return app.exit(error) == 0 ? done : wrong_case;
    }
    options.directory = directory;
    if (*run_command) return run(name, settings, options, thread_count);
    if (*cases_command) list_cases();
    if (*check_command) check(name, settings);
    if (*keys_command) fmt::print("{}", keys_page());
    if (*plot_command) return plot(directory, with);
    if (*bench_command) bench(bench_options);
    return done;
}

}  // namespace

}  // namespace coronet

int main(int argc, char** argv) {
    coronet::let_idle_threads_sleep(argv);
    coronet::return_freed_memory();
    try {
        return coronet::start(argc, argv);
    } catch (coronet::CaseError const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return coronet::wrong_case;
    } catch (std::bad_alloc const&) {
        fmt::print(stderr, "the memory has run out: use a larger particles.spacing\n");
        return coronet::failed_run;
    } catch (std::exception const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return coronet::failed_run;
    }
}
