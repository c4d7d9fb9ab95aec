// SPDX-License-Identifier: BSD-3-Clause

// A frame is read back here with HDF5 alone, by tests/io/read_frame.py with VTK. The file is left where the
// environment variable CORONET_TEST_FRAME says, so that the second reads what the first has written.
#include "coronet/io/frame.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using coronet::Frame;

class FrameFile : public ::testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    fs::path folder = fs::temp_directory_path() / ("coronet_frame_test." + std::to_string(getpid()));
};

std::vector<double> counting(std::size_t size, double first) {
    std::vector<double> values(size);
    std::iota(values.begin(), values.end(), first);
    return values;
}

/// `depth` = 0 gives the frame of a 2D run: every z is zero.
Frame sample(std::size_t count, double depth) {
    Frame frame{.time = 0.0125, .points = counting(3 * count, 0.5), .ids = {}, .fields = {}};
    for (std::size_t i = 0; i < count; ++i) {
        frame.points[3 * i + 2] *= depth;
        frame.ids.push_back(static_cast<std::int64_t>(count - i));  // particles are re-ordered in a run
    }
    frame.fields = {{"pressure", "Pa", 1, counting(count, -3.0)},
                    {"velocity", "m/s", 3, counting(3 * count, 10.0)},
                    {"stress", "Pa", 6, counting(6 * count, 20.0)},
                    {"gradient", "", 9, counting(9 * count, 30.0)}};
    return frame;
}

struct Table {
    std::vector<hsize_t> shape;
    std::vector<double> values;
};

Table read(fs::path const& path, std::string const& name) {
    auto const file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    auto const data = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    auto const space = H5Dget_space(data);
    Table table;
    table.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, table.shape.data(), nullptr);
    table.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data());
    H5Sclose(space);
    H5Dclose(data);
    H5Fclose(file);
    return table;
}

std::string read_attribute(fs::path const& path, std::string const& object, char const* name) {
    auto const file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    auto const attribute = H5Aopen_by_name(file, object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    auto const type = H5Aget_type(attribute);
    std::string text(H5Tget_size(type), '?');
    H5Aread(attribute, type, text.data());
    H5Tclose(type);
    H5Aclose(attribute);
    H5Fclose(file);
    return text;
}

void expect_written(fs::path const& file, Frame const& frame) {
    auto const count = frame.ids.size();
    EXPECT_EQ(read_attribute(file, "VTKHDF", "Type"), "UnstructuredGrid");
    EXPECT_EQ(read(file, "VTKHDF/Points").values, frame.points);
    EXPECT_EQ(read(file, "VTKHDF/Points").shape, (std::vector<hsize_t>{count, 3}));
    EXPECT_EQ(read(file, "VTKHDF/FieldData/Time").values, std::vector<double>{frame.time});
    EXPECT_EQ(read(file, "VTKHDF/NumberOfCells").values, std::vector<double>{double(count)});
    EXPECT_EQ(read(file, "VTKHDF/Types").values, std::vector<double>(count, 1.0));
    EXPECT_EQ(read(file, "VTKHDF/Connectivity").values, counting(count, 0));
    EXPECT_EQ(read(file, "VTKHDF/Offsets").values, counting(count + 1, 0));
    auto const ids = std::vector<double>(frame.ids.begin(), frame.ids.end());
    EXPECT_EQ(read(file, "VTKHDF/PointData/id").values, ids);
    for (auto const& field : frame.fields) {
        auto const table = read(file, "VTKHDF/PointData/" + field.name);
        EXPECT_EQ(table.values, field.values) << field.name;
        EXPECT_EQ(table.shape.size(), field.components == 1 ? 1u : 2u) << field.name;
        EXPECT_EQ(table.shape[0], count) << field.name;
    }
    EXPECT_EQ(read_attribute(file, "VTKHDF/PointData/velocity", "unit"), "m/s");
}

TEST_F(FrameFile, HoldsInTwoDimensionsEveryNumberAsWritten) {
    auto const frame = sample(5, 0.0);
    write_frame(folder / "000000.vtkhdf", frame);
    expect_written(folder / "000000.vtkhdf", frame);
}

TEST_F(FrameFile, HoldsInThreeDimensionsEveryNumberAsWritten) {
    auto const wanted = std::getenv("CORONET_TEST_FRAME");
    auto const file = wanted ? fs::path(wanted) : folder / "000001.vtkhdf";
    auto const frame = sample(7, 1.0);
    write_frame(file, frame);
    expect_written(file, frame);
}

TEST_F(FrameFile, OfNoParticlesIsAFrame) {
    write_frame(folder / "000000.vtkhdf", sample(0, 1.0));
    EXPECT_TRUE(read(folder / "000000.vtkhdf", "VTKHDF/Points").values.empty());
}

TEST_F(FrameFile, LeavesNothingButItself) {
    write_frame(folder / "000000.vtkhdf", sample(5, 1.0));
    write_frame(folder / "000000.vtkhdf", sample(6, 1.0));
    EXPECT_EQ(read(folder / "000000.vtkhdf", "VTKHDF/PointData/id").values.size(), 6u);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(FrameFile, WhoseFieldIsTooShortIsRefusedByName) {
    auto frame = sample(5, 1.0);
    frame.fields[1].values.pop_back();
    try {
        write_frame(folder / "000000.vtkhdf", frame);
        FAIL() << "a velocity of 14 numbers was accepted for 5 particles";
    } catch (std::invalid_argument const& error) {
        EXPECT_NE(std::string(error.what()).find("15 numbers of 'velocity', but has 14"), std::string::npos);
    }
}

TEST_F(FrameFile, ThatCannotBeOpenedIsNamedAndNothingElseIsPrinted) {
    auto const file = folder / "missing" / "000000.vtkhdf";
    ::testing::internal::CaptureStderr();
    try {
        write_frame(file, sample(5, 1.0));
        FAIL() << "a frame was written into a folder that does not exist";
    } catch (std::runtime_error const& error) {
        EXPECT_EQ(error.what(), "cannot write " + file.string() + ": No such file or directory");
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

/// A file size limit stands in for a full disk: the write call fails in the same place.
TEST_F(FrameFile, OnAFullDiskKeepsTheFrameBeforeIt) {
    auto const file = folder / "000000.vtkhdf";
    auto const before = sample(5, 1.0);
    write_frame(file, before);
    for (auto const bytes : {0, 1000, 20000}) {
        auto const default_action = std::signal(SIGXFSZ, SIG_IGN);
        rlimit limit{};
        getrlimit(RLIMIT_FSIZE, &limit);
        auto const unlimited = limit;
        limit.rlim_cur = static_cast<rlim_t>(bytes);
        setrlimit(RLIMIT_FSIZE, &limit);
        std::string message;
        try {
            write_frame(file, sample(1000, 1.0));
        } catch (std::runtime_error const& error) {
            message = error.what();
        }
        setrlimit(RLIMIT_FSIZE, &unlimited);
        std::signal(SIGXFSZ, default_action);
        EXPECT_EQ(message, "cannot write " + file.string() + ": File too large") << "limit of " << bytes;
        EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "limit of " << bytes;
    }
    expect_written(file, before);
}

TEST_F(FrameFile, SeriesListsNamesAndTimes) {
    coronet::write_frame_series(folder, {{"frames/000000.vtkhdf", 0.0}, {"frames/000001.vtkhdf", 0.0125}});
    std::stringstream text;
    text << std::ifstream(folder / "frames.vtkhdf.series").rdbuf();
    EXPECT_EQ(text.str(), R"({
 "file-series-version": "1.0",
 "files": [
  {
   "name": "frames/000000.vtkhdf",
   "time": 0.0
  },
  {
   "name": "frames/000001.vtkhdf",
   "time": 0.0125
  }
 ]
}
)");
}

TEST_F(FrameFile, SeriesThatCannotBeWrittenIsNamed) {
    EXPECT_THROW(coronet::write_frame_series(folder / "missing", {}), std::runtime_error);
}

}  // namespace
