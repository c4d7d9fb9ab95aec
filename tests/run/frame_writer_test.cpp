// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/run/frame_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <future>
#include <iterator>
#include <nlohmann/json.hpp>

#include "coronet/core/error.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using coronet::Frame;
using coronet::FrameWriter;
using coronet::RunError;
using Times = std::vector<double>;

Frame frame_at(double time) {
    std::vector<double> const pressure{time, 2 * time};
    return {.time = time, .points = Times(6, time), .ids = {7, 8}, .fields = {{"pressure", "Pa", 1, pressure}}};
}

std::string bytes(fs::path const& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// What a write waits at until the test lets it through. A test that would wait for ever fails instead.
class Gate {
public:
    void open() { door_.set_value(); }
    void pass() const {
        if (opened_.wait_for(20s) != std::future_status::ready) throw RunError("the run waits for the disk");
    }
    bool is_open() const { return opened_.wait_for(0s) == std::future_status::ready; }

private:
    std::promise<void> door_;
    std::shared_future<void> opened_ = door_.get_future().share();
};

class AFrameWriter : public ::testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder / "frames"); }
    void TearDown() override { fs::remove_all(folder); }

    Times listed() const {
        Times times;
        if (!fs::exists(folder / "frames.vtkhdf.series")) return times;
        auto const series = nlohmann::json::parse(bytes(folder / "frames.vtkhdf.series"));
        for (auto const& file : series["files"]) {
            EXPECT_EQ(file["name"], "frames/00000" + std::to_string(times.size()) + ".vtkhdf");
            EXPECT_TRUE(fs::exists(folder / file["name"])) << file["name"];
            times.push_back(file["time"]);
        }
        return times;
    }

    /// Refuses the frames of negative time.
    static void picky(fs::path const& file, Frame const& frame) {
        if (frame.time < 0) throw RunError("cannot write " + file.filename().string());
        write_frame(file, frame);
    }

    fs::path folder = fs::temp_directory_path() / ("coronet_frame_writer_test." + std::to_string(getpid()));
};

TEST_F(AFrameWriter, WritesFramesInOrderAndWhole) {
    FrameWriter writer(folder);
    for (int k = 0; k < 9; ++k) writer.push(frame_at(k));
    writer.drain();
    EXPECT_EQ(listed(), (Times{0, 1, 2, 3, 4, 5, 6, 7, 8}));
    for (int k = 0; k < 9; ++k) {
        write_frame(folder / "wanted", frame_at(k));  // equal frames are equal files
        EXPECT_EQ(bytes(folder / "frames" / ("00000" + std::to_string(k) + ".vtkhdf")), bytes(folder / "wanted"));
    }
}

TEST_F(AFrameWriter, ListsAFrameOnlyOnceItIsWritten) {
    std::vector<std::size_t> listed_meanwhile;
    FrameWriter writer(folder, [&](fs::path const& file, Frame const& frame) {
        write_frame(file, frame);
        listed_meanwhile.push_back(listed().size());
    });
    for (int k = 0; k < 3; ++k) writer.push(frame_at(k));
    writer.drain();
    EXPECT_EQ(listed_meanwhile, (std::vector<std::size_t>{0, 1, 2}));
}

TEST_F(AFrameWriter, LetsOneFrameWaitWhileAnotherIsWrittenAndHoldsTheThird) {
    Gate gate;
    FrameWriter writer(folder, [&](fs::path const& file, Frame const& frame) {
        gate.pass();
        write_frame(file, frame);
    });
    writer.push(frame_at(0));
    writer.push(frame_at(1));
    EXPECT_TRUE(listed().empty());
    auto third = std::async(std::launch::async, [&] {
        writer.push(frame_at(2));
        return gate.is_open();
    });
    third.wait_for(50ms);  // time to go wrong; to go right takes none
    gate.open();
    EXPECT_TRUE(third.get()) << "three frames were pending";
    writer.drain();
    EXPECT_EQ(listed(), (Times{0, 1, 2}));
}

TEST_F(AFrameWriter, DrainsOnlyWhenTheLastFrameIsOnDisk) {
    Gate gate;
    FrameWriter writer(folder, [&](fs::path const& file, Frame const& frame) {
        gate.pass();
        write_frame(file, frame);
    });
    writer.push(frame_at(0));
    auto drained = std::async(std::launch::async, [&] {
        writer.drain();
        return listed();
    });
    drained.wait_for(50ms);  // time to go wrong
    gate.open();
    EXPECT_EQ(drained.get(), Times{0});
}

TEST_F(AFrameWriter, TellsAFailureAtALaterPushWhichThenTakesNothing) {
    Gate gate;
    FrameWriter writer(folder, [&](fs::path const& file, Frame const& frame) {
        gate.pass();
        picky(file, frame);
    });
    writer.push(frame_at(-1));
    writer.push(frame_at(1));
    gate.open();
    try {
        writer.push(frame_at(2));  // it waits until frame 1 has left its place: then the first has failed
        FAIL() << "the failure was not told";
    } catch (RunError const& error) {
        EXPECT_STREQ(error.what(), "cannot write 000000.vtkhdf");
    }
    writer.push(frame_at(3));
    writer.drain();
    EXPECT_EQ(listed(), (Times{1, 3}));  // those before and after the failure, without a gap in their numbers
}

TEST_F(AFrameWriter, TellsTheFailureOfTheLastFrameAtTheDrainAndOnce) {
    FrameWriter writer(folder, picky);
    writer.push(frame_at(0));
    writer.drain();
    writer.push(frame_at(-1));
    EXPECT_THROW(writer.drain(), RunError);
    EXPECT_NO_THROW(writer.drain());
    EXPECT_EQ(listed(), Times{0});
}

TEST_F(AFrameWriter, TellsTheFirstOfTwoFailures) {
    Gate gate;
    FrameWriter writer(folder, [&](fs::path const&, Frame const& frame) {
        gate.pass();
        throw RunError(frame.time == 0 ? "the first" : "another");
    });
    writer.push(frame_at(0));
    writer.push(frame_at(1));
    gate.open();
    try {
        writer.drain();
        FAIL() << "the failure was not told";
    } catch (RunError const& error) {
        EXPECT_STREQ(error.what(), "the first");
    }
}

TEST_F(AFrameWriter, TellsThatTheSeriesCannotBeWritten) {
    fs::create_directories(folder / "frames.vtkhdf.series");  // nothing can be renamed to it
    FrameWriter writer(folder);
    writer.push(frame_at(0));
    EXPECT_THROW(writer.drain(), RunError);
}

TEST_F(AFrameWriter, WritesAllItHasBeforeItGoes) {
    Gate gate;
    {
        FrameWriter writer(folder, [&](fs::path const& file, Frame const& frame) {
            gate.pass();
            picky(file, frame);
        });
        writer.push(frame_at(0));
        writer.push(frame_at(1));
        gate.open();
    }
    EXPECT_EQ(listed(), (Times{0, 1}));
}

TEST_F(AFrameWriter, GoesInSilenceWhereAFrameFailed) {
    {
        FrameWriter writer(folder, picky);
        writer.push(frame_at(-1));
    }
    EXPECT_TRUE(listed().empty());
}

}  // namespace
