// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/run.hpp"

#include <chrono>
#include <cstdio>

#include <fmt/format.h>

#include "coronet/cases/closed_surface.hpp"
#include "coronet/cases/fluid.hpp"
#include "coronet/cases/read.hpp"
#include "coronet/cases/set_up.hpp"
#include "coronet/core/error.hpp"
#include "coronet/io/frame.hpp"
#include "coronet/io/whole_file.hpp"
#include "coronet/run/interrupt.hpp"
#include "coronet/run/output_clock.hpp"
#include "coronet/run/progress.hpp"
#include "coronet/run/recorder.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;

/// Makes the directory ready. Only what a run writes is ever removed from it.
void prepare(fs::path const& directory, bool overwrite) {
    bool const holds_run = fs::exists(directory / "case.toml") || fs::exists(directory / "series.csv");
    if (holds_run && !overwrite)
        throw CaseError(fmt::format("{} already holds a run: choose another --out, or give --overwrite to replace it",
                                    directory.string()));
    std::error_code failed;
    for (char const* const name : {"case.toml", "flow_curve.csv", "initial.vtkhdf", "series.csv", "profiles.csv",
                                   "summary.json", "frames", "frames.vtkhdf.series", "figures"})
        if (holds_run) fs::remove_all(directory / name, failed);
    fs::create_directories(directory / "frames", failed);
    if (failed) throw CaseError(fmt::format("{} cannot be made: {}", directory.string(), failed.message()));
}

/// Keeps the liquid that the run starts from beside the case, which names it from then on: what it was read from may be
/// a frame of a run that this one replaces.
void keep_initial_frame(Case& as_run, fs::path const& directory) {
    if (!as_run.initial.frame) return;
    as_run.initial.from = "initial.vtkhdf";
    write_frame(directory / as_run.initial.from, *as_run.initial.frame);
}

/// Copies the files that walls were read from beside the case, which names the copies from then on.
void keep_surfaces(Case& as_run, fs::path const& directory) {
    for (std::size_t k = 0; k < as_run.walls.size(); ++k) {
        Wall& wall = as_run.walls[k];
        if (!wall.surface) continue;
        fs::path const from = wall.surface->file();
        wall.file = fmt::format("wall_{}{}", k, from.extension().string());
        auto const to = directory / wall.file;
        std::error_code failed;
        if (fs::equivalent(from, to, failed)) continue;  // the run goes where its case lies
        fs::copy_file(from, to, fs::copy_options::overwrite_existing, failed);
        if (failed) throw CaseError(fmt::format("{} cannot be written: {}", to.string(), failed.message()));
    }
}

std::string advice(Case const& c) {
    if (c.method.scheme == "projection")
        return "A shorter time.step may help, a larger method.compact_share where the solve did not converge, or some "
               "method.artificial_viscosity; a yield stress wants method.viscous_step = 'implicit'";
    std::string text = c.time.step > 0 ? "A smaller time.step or 'auto' may help" : "A smaller time.courant may help";
    text += ", a larger fluid.sound_speed if the flow has come near it, or some method.artificial_viscosity";
    if (c.method.gradient != "sph") text += "; where liquid merges or tears, method.gradient = 'sph' bears most";
    return text;
}

/// A step that the case has is taken as it is, known to be stable or not.
void note_long_step(double step, StepLimit const& stable, Progress& progress) {
    if (step <= stable.step) return;
    progress.end_line();
    fmt::print(stderr,
               "note: the step {:g} s (time.step) is longer than the {:.3g} s that {} would let \"auto\" take here: if "
               "the run fails or its energy grows, make it shorter\n",
               step, stable.step, stable.reason);
}

template <int D>
RunStatus run(Case const& c, RunOptions const& options) {
    auto const start = std::chrono::steady_clock::now();
    auto const scheme = make_scheme<D>(c);
    Recorder<D> recorder(c, options.directory, *scheme);
    Progress progress(options.quiet, c.time.end, scheme->particles().owned());
    OutputClock rows(c.output.series_every, c.time.end), frames(c.output.every, c.time.end);

    double time = 0, dt = 0;
    std::int64_t steps = 0;
    auto const finish = [&](std::string const& status, std::string const& message) {
        recorder.summary(status, message, steps,
                         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    };
    watch_for_interrupts();
    try {
        while (true) {
            scheme->begin_step(time);  // before output, so that a frame has the rates of its own time
            bool last = time >= c.time.end || interrupted();
            if (last || rows.due(time)) recorder.sample(time, steps, dt);
            last = last || recorder.settled();
            if (last || frames.due(time)) recorder.frame(time);
            rows.done(time);
            frames.done(time);
            progress.show(time, steps, last);
            if (last) break;

            StepLimit const limit = c.time.step > 0 ? StepLimit{c.time.step, "time.step"} : scheme->time_limit();
            if (!(limit.step > 1e-12 * c.time.end))
                throw RunError(
                    fmt::format("the stable time step fell to {:.3g} s because of {}", limit.step, limit.reason));
            double const due = std::min(rows.next(), frames.next());
            dt = fit_step(limit.step, due - time);
            if (steps == 0 && c.time.step > 0 && !options.quiet) note_long_step(dt, scheme->time_limit(), progress);
            scheme->advance(time, dt);
            time = dt == due - time ? due : time + dt;
            ++steps;
        }
        recorder.finish_frames();  // a run is done when its last frame is on disk
    } catch (RunError const& error) {
        std::string const message =
            fmt::format("the run failed at t = {:.6g} s, step {}: {}. {}; what was written is kept in {}", time, steps,
                        error.what(), advice(c), options.directory.string());
        auto const attempt = [](auto const& act) {
            try {
                act();
            } catch (std::exception const&) {
                // What failed first is the cause and in the message; a full disk, say, refuses these too.
            }
        };
        attempt([&] { recorder.frame(time); });  // where it went wrong is worth a look
        attempt([&] { recorder.finish_frames(); });
        attempt([&] { finish("failed", message); });
        throw RunError(message);
    }
    bool const stopped = time < c.time.end && !recorder.settled();
    finish(stopped ? "interrupted" : "done", "");
    return stopped ? RunStatus::interrupted : RunStatus::done;
}

}  // namespace

RunStatus run_case(Case const& c, RunOptions const& options) {
    prepare(options.directory, options.overwrite);
    Case as_run = c;
    if (c.flow_curve_fit) {
        as_run.fluid.flow_curve = "flow_curve.csv";
        write_whole(options.directory / as_run.fluid.flow_curve, write_flow_curve(*c.flow_curve_fit));
    }
    keep_surfaces(as_run, options.directory);
    keep_initial_frame(as_run, options.directory);
    write_whole(options.directory / "case.toml", write_case(as_run));
    return c.dimension == 2 ? run<2>(c, options) : run<3>(c, options);
}

}  // namespace coronet
