// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Files of triangles for tests: a cube, any triangles as STL, and a file that is gone when the test is over.

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "coronet/core/tensor.hpp"

namespace coronet {

using Mesh = std::vector<std::array<Vector<double, 3>, 3>>;

struct MeshFile {
    std::filesystem::path path;

    /// An empty text is no file at all, but for one named empty.
    MeshFile(std::string const& name, std::string const& text) {
        auto const folder = std::filesystem::temp_directory_path() / fmt::format("coronet_mesh_{}", getpid());
        std::filesystem::create_directories(folder);
        path = folder / name;
        if (!text.empty() || name.starts_with("empty")) std::ofstream(path, std::ios::binary) << text;
    }
    ~MeshFile() { std::filesystem::remove(path); }
    MeshFile(MeshFile const&) = delete;
    MeshFile& operator=(MeshFile const&) = delete;
};

inline std::vector<Vector<double, 3>> cube_corners() {
    std::vector<Vector<double, 3>> corners;
    for (int k = 0; k < 8; ++k) corners.push_back({{double(k & 1), double(k >> 1 & 1), double(k >> 2)}});
    return corners;
}

/// The faces of [0, 1]^3, seen from outside counter-clockwise.
inline std::vector<std::array<int, 4>> cube_faces() {
    return {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
}

inline Mesh cube() {
    auto const p = cube_corners();
    Mesh mesh;
    for (auto const& [a, b, c, d] : cube_faces()) {
        mesh.push_back({p[a], p[b], p[c]});
        mesh.push_back({p[a], p[c], p[d]});
    }
    return mesh;
}

inline std::string cube_obj() {
    std::string text = "# a cube\no cube\n";
    for (auto const& p : cube_corners()) text += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
    for (auto const& [a, b, c, d] : cube_faces())
        text += fmt::format("f {}/1 {} {}//2 {}\n", a + 1, b + 1, c - 8, d + 1);
    return text;
}

inline std::string ascii_stl(Mesh const& mesh) {
    std::string text = "solid mesh\n";
    for (auto const& triangle : mesh) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (auto const& p : triangle) text += fmt::format("  vertex {} {} {}\n", p[0], p[1], p[2]);
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid mesh\n";
}

inline std::string binary_stl(Mesh const& mesh) {
    std::string bytes(80, ' ');
    auto const add = [&](auto const& value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    add(static_cast<std::uint32_t>(mesh.size()));
    for (auto const& triangle : mesh) {
        for (int k = 0; k < 3; ++k) add(0.0f);
        for (auto const& p : triangle)
            for (int k = 0; k < 3; ++k) add(static_cast<float>(p[k]));
        add(std::uint16_t{0});
    }
    return bytes;
}

/// A sphere around 0 from an octahedron whose triangles are cut in four `cuts` times.
inline Mesh sphere(double radius, int cuts) {
    Mesh mesh;
    for (double const x : {-1.0, 1.0})
        for (double const y : {-1.0, 1.0})
            for (double const z : {-1.0, 1.0}) {
                Vector<double, 3> const a{{x, 0, 0}}, b{{0, y, 0}}, c{{0, 0, z}};
                if (x * y * z > 0) mesh.push_back({a, b, c});
                else mesh.push_back({a, c, b});
            }
    for (int n = 0; n < cuts; ++n) {
        Mesh finer;
        for (auto const& [a, b, c] : mesh) {
            auto const middle = [](auto const& p, auto const& q) {
                auto const m = p + q;
                return (1 / std::sqrt(norm2(m))) * m;
            };
            auto const ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.push_back({a, ab, ca});
            finer.push_back({ab, b, bc});
            finer.push_back({ca, bc, c});
            finer.push_back({ab, bc, ca});
        }
        mesh = finer;
    }
    for (auto& triangle : mesh)
        for (auto& p : triangle) p = radius * p;
    return mesh;
}

}  // namespace coronet
