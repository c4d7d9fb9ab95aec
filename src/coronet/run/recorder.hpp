// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Writes what a run leaves: the series, row by row, the frames, and at the end the summary (see docs/guide.md). Frames
// are only copied here; they reach the disk behind the run's back.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coronet/cases/probe.hpp"
#include "coronet/io/table.hpp"
#include "coronet/run/frame_writer.hpp"
#include "coronet/schemes/scheme.hpp"

namespace coronet {

template <int D>
class Recorder {
public:
    Recorder(Case const& c, std::filesystem::path directory, Scheme<D>& scheme);

    /// A row of the series. `step` counts from 0, `dt` is the last one taken.
    void sample(double time, std::int64_t step, double dt);
    /// Whether all profiles have settled, as the case says; as of the last sample.
    bool settled() const;
    /// A frame of now. Throws RunError where an earlier one could not be written.
    void frame(double time);
    /// Waits until all frames are on disk. Throws RunError where one could not be written.
    void finish_frames();
    /// summary.json. `status` is done, interrupted or failed; `message` says why.
    void summary(std::string const& status, std::string const& message, std::int64_t steps, double wall_seconds);

private:
    void write_profiles() const;

    Case const& case_;
    std::filesystem::path directory_;
    Scheme<D>& scheme_;
    std::vector<std::unique_ptr<Probe<D>>> probes_;
    Settling settling_;
    double change_;  // of the profiles
    std::optional<Table> series_;
    std::optional<FrameWriter> frames_;
    Arrangement arrangement_;
    Phases phases_;
};

}  // namespace coronet
