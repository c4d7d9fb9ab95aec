// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads the triangles of a surface from a file: STL, ASCII or binary, or OBJ (vertices and faces alone; a face of more
// than three corners is cut into a fan). Normals of the file are passed by: the order of the corners says which side is
// which.

#include <array>
#include <filesystem>
#include <vector>

#include "coronet/core/tensor.hpp"

namespace coronet {

struct Triangles {
    using Corner = Vector<double, 3>;
    std::vector<std::array<Corner, 3>> corners;  ///< in the file's unit
    std::vector<std::size_t> place;              ///< of each in the file: line, or in binary STL number, from 1
    bool in_lines = true;                        ///< which of both

    std::size_t size() const { return corners.size(); }
};

/// Throws CaseError, "file:line: what is wrong and what would be right", if the file cannot be read, is neither, is cut
/// short, holds something else than finite numbers, or no triangle.
Triangles read_triangles(std::filesystem::path const& file);

}  // namespace coronet
