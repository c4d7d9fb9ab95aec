// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Writes the frames of a run on a thread of its own, so that the run goes on while they reach the disk. At most one
// frame waits while another is written, so memory is bounded: the push of a third waits. What goes wrong is kept, and
// told to the run at a later push or drain. HDF5, which not every build lets two threads use, is used in a run by this
// thread alone.

#include <condition_variable>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "coronet/io/frame.hpp"

namespace coronet {

/// Called from one thread. Frames come to `directory` as frames/000000.vtkhdf, ... in the order of their pushes, and
/// into frames.vtkhdf.series once they are whole; one that cannot be written leaves its number to the next.
class FrameWriter {
public:
    using Write = std::function<void(std::filesystem::path const&, Frame const&)>;

    explicit FrameWriter(std::filesystem::path directory, Write write = write_frame);
    FrameWriter(FrameWriter const&) = delete;
    FrameWriter& operator=(FrameWriter const&) = delete;
    /// Drains, and keeps to itself what goes wrong.
    ~FrameWriter();

    /// Throws what first went wrong with the frames since the last throw; this one is then not taken.
    void push(Frame frame);
    /// Waits until no frame is left to write. Throws like push.
    void drain();

private:
    void work();
    void write(Frame const& frame);
    void tell_failure();

    std::filesystem::path directory_;
    Write write_;
    std::vector<std::pair<std::string, double>> written_;  // of the thread alone

    std::mutex mutex_;  // guards what follows
    std::condition_variable changed_;
    std::optional<Frame> waiting_;
    bool writing_ = false, ended_ = false;
    std::exception_ptr failure_;

    std::thread thread_;  // last: it uses all of the above
};

}  // namespace coronet
