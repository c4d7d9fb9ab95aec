// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "coronet/surface/mesh.hpp"

namespace coronet {

/// Expects each side of a triangle to be one of another, the other way.
inline void expect_closed(SurfaceMesh const& mesh) {
    std::vector<std::pair<Index, Index>> sides, reversed;
    for (auto const& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            sides.emplace_back(t[k], t[(k + 1) % 3]);
            reversed.emplace_back(t[(k + 1) % 3], t[k]);
        }
    std::sort(sides.begin(), sides.end());
    std::sort(reversed.begin(), reversed.end());
    EXPECT_EQ(sides, reversed);
}

}  // namespace coronet
