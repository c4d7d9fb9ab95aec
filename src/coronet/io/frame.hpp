// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Frames: the particles at one instant, in a file that ParaView 5.11 and VTK 9.1 open as it is. The format is
// VTKHDF 1.0 (docs.vtk.org, "VTKHDF file format"), written as an UnstructuredGrid with one vertex cell per
// particle because the readers of that time know no PolyData. A frame is whole or absent: it is written under
// another name and renamed. Particles of walls are in it, too: where there are any, a field `wall` is 1 for them.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coronet {

/// One field of a frame: `components` numbers per particle (1, 3, 6 or 9), laid out particle after particle.
/// Six are the symmetric tensor in ParaView's order: xx, yy, zz, xy, yz, xz.
struct FrameField {
    std::string name;
    std::string unit;
    int components = 1;
    std::vector<double> values;
};

/// What a frame holds, SI units: three coordinates per particle in `points` (z = 0 in 2D), an identity in
/// `ids`.
struct Frame {
    double time = 0;
    std::vector<double> points;
    std::vector<std::int64_t> ids;
    std::vector<FrameField> fields;
};

/// The field of that name; null where there is none.
FrameField const* field_of(Frame const& frame, std::string_view name);

/// Throws std::invalid_argument where the parts of the frame do not match.
void check(Frame const& frame);

/// Throws std::invalid_argument where the parts of the frame do not match, RunError where the disk refuses.
void write_frame(std::filesystem::path const& file, Frame const& frame);

/// The frame that write_frame() left, its fields in the order of their names. Throws CaseError, "file: what is wrong".
Frame read_frame(std::filesystem::path const& file);

/// Writes frames.vtkhdf.series (ParaView's file series, JSON) into `directory`: file names relative to it,
/// times in s.
void write_frame_series(std::filesystem::path const& directory,
                        std::vector<std::pair<std::string, double>> const& frames);

}  // namespace coronet
