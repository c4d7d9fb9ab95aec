// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/frame.hpp"
#include "coronet/io/hdf5.hpp"

#include <fmt/format.h>

#include <array>

namespace coronet {
namespace {

namespace fs = std::filesystem;

hid_t read_as(double) { return H5T_NATIVE_DOUBLE; }
hid_t read_as(std::int64_t) { return H5T_NATIVE_INT64; }

template <typename Number>
struct Table {
    std::vector<Number> values;
    int columns = 1;
    std::string unit;
};

std::string unit_of(hid_t table) {
    if (checked(H5Aexists(table, "unit")) == 0) return {};
    Handle const attribute(H5Aopen(table, "unit", H5P_DEFAULT), H5Aclose);
    Handle const type(H5Aget_type(attribute), H5Tclose);
    if (checked(H5Tis_variable_str(type)) > 0) return {};
    std::string text(H5Tget_size(type), '\0');
    checked(H5Aread(attribute, type, text.data()));
    return text;
}

template <typename Number>
Table<Number> read_table(hid_t group, std::string const& name) {
    Handle const table(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
    Handle const space(H5Dget_space(table), H5Sclose);
    std::array<hsize_t, H5S_MAX_RANK> shape{};
    int const rank = checked(H5Sget_simple_extent_dims(space, shape.data(), nullptr));
    Table<Number> found;
    if (rank > 1) found.columns = static_cast<int>(shape[1]);
    found.values.resize(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))));
    checked(H5Dread(table, read_as(Number{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, found.values.data()));
    found.unit = unit_of(table);
    return found;
}

/// In the order of their names.
std::vector<std::string> names_in(hid_t group) {
    std::vector<std::string> names;
    auto const add = [](hid_t, char const* name, H5L_info_t const*, void* list) {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return herr_t(0);
    };
    checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names));
    return names;
}

Frame read_vtkhdf(hid_t file) {
    Handle const root(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), H5Gclose);
    Frame frame;
    frame.points = read_table<double>(root, "Points").values;

    Handle const general(H5Gopen2(root, "FieldData", H5P_DEFAULT), H5Gclose);
    auto const time = read_table<double>(general, "Time");
    if (time.values.size() != 1) throw CaseError(fmt::format("its Time has {} values, not one", time.values.size()));
    frame.time = time.values[0];

    Handle const fields(H5Gopen2(root, "PointData", H5P_DEFAULT), H5Gclose);
    for (auto const& name : names_in(fields)) {
        if (name == "id") {
            frame.ids = read_table<std::int64_t>(fields, name).values;
            continue;
        }
        auto table = read_table<double>(fields, name);
        frame.fields.push_back({name, std::move(table.unit), table.columns, std::move(table.values)});
    }
    check(frame);
    return frame;
}

}  // namespace

Frame read_frame(fs::path const& file) {
    if (!fs::is_regular_file(file)) throw CaseError(fmt::format("{}: there is no such file", file.string()));
    SilentHdf5 const silence;
    try {
        Handle const opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
        return read_vtkhdf(opened);
    } catch (CaseError const& error) {
        throw CaseError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (std::invalid_argument const& error) {
        throw CaseError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (RunError const&) {
        throw CaseError(fmt::format("{}: this is no frame as runs write them, frames/NNNNNN.vtkhdf, or it is cut short",
                                    file.string()));
    }
}

}  // namespace coronet
