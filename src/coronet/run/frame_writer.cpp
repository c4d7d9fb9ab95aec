// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/frame_writer.hpp"

#include <fmt/format.h>

namespace coronet {

FrameWriter::FrameWriter(std::filesystem::path directory, Write write)
    : directory_(std::move(directory)), write_(std::move(write)), thread_([this] { work(); }) {}

FrameWriter::~FrameWriter() {
    {
        std::lock_guard const lock(mutex_);
        ended_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void FrameWriter::push(Frame frame) {
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !waiting_; });
        tell_failure();
        waiting_ = std::move(frame);
    }
    changed_.notify_all();
}

void FrameWriter::drain() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !waiting_ && !writing_; });
    tell_failure();
}

void FrameWriter::tell_failure() {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void FrameWriter::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return waiting_ || ended_; });
        if (!waiting_) return;  // only then: what was pushed before the end is still written
        std::optional<Frame> frame = std::exchange(waiting_, std::nullopt);
        writing_ = true;
        lock.unlock();
        changed_.notify_all();

        std::exception_ptr failure;
        try {
            write(*frame);
        } catch (...) {
            failure = std::current_exception();
        }
        frame.reset();  // not under the lock: to free much takes long

        lock.lock();
        writing_ = false;
        if (!failure_) failure_ = std::move(failure);  // the first is the cause
        changed_.notify_all();
    }
}

void FrameWriter::write(Frame const& frame) {
    auto const name = fmt::format("frames/{:06}.vtkhdf", written_.size());
    write_(directory_ / name, frame);
    written_.emplace_back(name, frame.time);
    write_frame_series(directory_, written_);
}

}  // namespace coronet
