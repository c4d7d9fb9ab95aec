// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/frame.hpp"

#include "coronet/io/hdf5.hpp"
#include "coronet/io/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string_view>

namespace coronet {
namespace {

namespace fs = std::filesystem;

hid_t stored_as(double) { return H5T_NATIVE_DOUBLE; }
hid_t stored_as(std::int64_t) { return H5T_NATIVE_INT64; }
hid_t stored_as(std::uint8_t) { return H5T_NATIVE_UINT8; }

void write_attribute(hid_t object, char const* name, std::string_view text) {
    if (text.empty()) return;  // HDF5 has no string of length zero

    // Fixed length and ASCII: VTK 9.1 takes no other.
    Handle const type(H5Tcopy(H5T_C_S1), H5Tclose);
    checked(H5Tset_size(type, text.size()));
    checked(H5Tset_strpad(type, H5T_STR_NULLPAD));
    Handle const space(H5Screate(H5S_SCALAR), H5Sclose);
    Handle const attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    checked(H5Awrite(attribute, type, text.data()));
}

void write_version(hid_t object) {
    std::int64_t const version[] = {1, 0};
    hsize_t const size = 2;
    Handle const space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    Handle const attribute(H5Acreate2(object, "Version", H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    checked(H5Awrite(attribute, H5T_NATIVE_INT64, version));
}

/// Without the time of writing, so that equal frames are equal files.
hid_t without_clock(hid_t object_class) {
    hid_t const properties = checked(H5Pcreate(object_class));
    checked(H5Pset_obj_track_times(properties, false));
    return properties;
}

/// A table of `components` columns; one column is written as a plain list, as VTK expects of scalars.
template <typename Number>
void write_table(hid_t group, std::string const& name, std::span<Number const> values, int components = 1,
                 std::string_view unit = {}) {
    auto const columns = static_cast<hsize_t>(components);
    hsize_t const shape[] = {values.size() / columns, columns};
    auto const type = stored_as(Number{});
    Handle const space(H5Screate_simple(components == 1 ? 1 : 2, shape, nullptr), H5Sclose);
    Handle const timeless(without_clock(H5P_DATASET_CREATE), H5Pclose);
    Handle const table(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, timeless, H5P_DEFAULT), H5Dclose);
    if (!values.empty()) checked(H5Dwrite(table, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    write_attribute(table, "unit", unit);
}

hid_t new_group(hid_t parent, char const* name) {
    Handle const timeless(without_clock(H5P_GROUP_CREATE), H5Pclose);
    return H5Gcreate2(parent, name, H5P_DEFAULT, timeless, H5P_DEFAULT);
}

/// Cell k is the vertex k: connectivity 0 1 2 ..., offsets 0 1 2 ... n.
void write_vertices(hid_t root, std::size_t count) {
    using Numbers = std::span<std::int64_t const>;
    auto const total = static_cast<std::int64_t>(count);
    for (auto name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        write_table(root, name, Numbers(&total, 1));

    std::vector<std::int64_t> numbers(count + 1);
    std::iota(numbers.begin(), numbers.end(), 0);
    write_table(root, "Connectivity", Numbers(numbers).first(count));
    write_table(root, "Offsets", Numbers(numbers));

    std::uint8_t const vertex = 1;  // VTK_VERTEX
    std::vector<std::uint8_t> const types(count, vertex);
    write_table(root, "Types", std::span(types));
}

void write_vtkhdf(hid_t file, Frame const& frame) {
    Handle const root(new_group(file, "VTKHDF"), H5Gclose);
    write_version(root);
    write_attribute(root, "Type", "UnstructuredGrid");
    write_vertices(root, frame.ids.size());
    write_table(root, "Points", std::span(frame.points), 3, "m");

    Handle const fields(new_group(root, "PointData"), H5Gclose);
    write_table(fields, "id", std::span(frame.ids));
    for (auto const& field : frame.fields)
        write_table(fields, field.name, std::span(field.values), field.components, field.unit);

    Handle const general(new_group(root, "FieldData"), H5Gclose);
    write_table(general, "Time", std::span(&frame.time, 1), 1, "s");
}

/// The bytes of the file, composed in memory: a file that HDF5 itself cannot finish on a full disk can no
/// longer be closed and brings the process down at its exit.
std::string vtkhdf_image(Frame const& frame) {
    SilentHdf5 const silence;
    std::size_t const growth = 1 << 20;
    Handle const in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    checked(H5Pset_fapl_core(in_memory, growth, false));
    Handle const file(H5Fcreate("frame", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory), H5Fclose);
    write_vtkhdf(file, frame);
    checked(H5Fflush(file, H5F_SCOPE_LOCAL));
    std::string image(static_cast<std::size_t>(checked(H5Fget_file_image(file, nullptr, 0))), '\0');
    checked(H5Fget_file_image(file, image.data(), image.size()));
    return image;
}

}  // namespace

FrameField const* field_of(Frame const& frame, std::string_view name) {
    auto const found = std::find_if(frame.fields.begin(), frame.fields.end(),
                                    [&](FrameField const& field) { return field.name == name; });
    return found == frame.fields.end() ? nullptr : &*found;
}

void check(Frame const& frame) {
    auto const count = frame.ids.size();
    auto const expect = [&](std::string const& name, std::size_t found, std::size_t wanted) {
        if (found != wanted)
            throw std::invalid_argument("a frame of " + std::to_string(count) + " particles needs " +
                                        std::to_string(wanted) + " numbers of '" + name + "', but has " +
                                        std::to_string(found));
    };
    expect("points", frame.points.size(), 3 * count);
    for (auto const& field : frame.fields)
        expect(field.name, field.values.size(), static_cast<std::size_t>(field.components) * count);
}

void write_frame(fs::path const& file, Frame const& frame) {
    check(frame);
    write_whole(file, vtkhdf_image(frame));
}

void write_frame_series(fs::path const& directory, std::vector<std::pair<std::string, double>> const& frames) {
    auto files = nlohmann::ordered_json::array();
    for (auto const& [name, time] : frames) files.push_back({{"name", name}, {"time", time}});
    nlohmann::ordered_json const series = {{"file-series-version", "1.0"}, {"files", files}};
    write_whole(directory / "frames.vtkhdf.series", series.dump(1) + "\n");
}

}  // namespace coronet
