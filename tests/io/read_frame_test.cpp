// SPDX-License-Identifier: BSD-3-Clause

// Frames are read back as they were written, and what is none is refused.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "coronet/core/error.hpp"
#include "coronet/io/frame.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;

class ReadFrame : public ::testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string complaint() const {
        try {
            read_frame(file);
            return "none";
        } catch (CaseError const& error) {
            return error.what();
        }
    }

    fs::path folder = fs::temp_directory_path() / ("coronet_read_frame_test." + std::to_string(getpid()));
    fs::path file = folder / "000003.vtkhdf";
};

Frame const sample{.time = 0.0125,
                   .points = {0.1, 0.2, 0.3, 1.1, 1.2, 1.3},
                   .ids = {7, 2},
                   .fields = {{"density", "kg/m^3", 1, {1000.5, 999.25}},
                              {"stress", "Pa", 6, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
                              {"surface", "", 1, {0, 1}},
                              {"velocity", "m/s", 3, {0.1, -0.2, 0, 1e-300, 5, 6}}}};

void expect_same(Frame const& found, Frame const& wanted) {
    EXPECT_EQ(found.time, wanted.time);
    EXPECT_EQ(found.points, wanted.points);
    EXPECT_EQ(found.ids, wanted.ids);
    ASSERT_EQ(found.fields.size(), wanted.fields.size());
    for (std::size_t k = 0; k < wanted.fields.size(); ++k) {
        EXPECT_EQ(found.fields[k].name, wanted.fields[k].name);
        EXPECT_EQ(found.fields[k].unit, wanted.fields[k].unit) << wanted.fields[k].name;
        EXPECT_EQ(found.fields[k].components, wanted.fields[k].components) << wanted.fields[k].name;
        EXPECT_EQ(found.fields[k].values, wanted.fields[k].values) << wanted.fields[k].name;
    }
}

TEST_F(ReadFrame, GivesWhatWasWritten) {
    write_frame(file, sample);
    expect_same(read_frame(file), sample);
}

TEST_F(ReadFrame, OfNoParticlesGivesNone) {
    Frame empty = sample;
    empty.points.clear();
    empty.ids.clear();
    for (auto& field : empty.fields) field.values.clear();
    write_frame(file, empty);
    expect_same(read_frame(file), empty);
}

TEST_F(ReadFrame, ThatIsNotThereIsNamed) {
    EXPECT_EQ(complaint(), file.string() + ": there is no such file");
    file = folder;
    EXPECT_EQ(complaint(), file.string() + ": there is no such file");
}

TEST_F(ReadFrame, ThatIsNoneIsRefusedAndNothingElseIsPrinted) {
    std::string const refusal =
        file.string() + ": this is no frame as runs write them, frames/NNNNNN.vtkhdf, or it is cut short";
    ::testing::internal::CaptureStderr();
    std::ofstream(file) << "name = \"a case\"\n";
    EXPECT_EQ(complaint(), refusal);
    write_frame(file, sample);
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_EQ(complaint(), refusal);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace

}  // namespace coronet
