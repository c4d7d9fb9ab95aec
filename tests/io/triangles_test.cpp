// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/triangles.hpp"

#include <gtest/gtest.h>

#include "coronet/core/error.hpp"
#include "tests/io/mesh_files.hpp"

namespace coronet {

namespace {

/// What is said about a file with this text.
std::string complaint(std::string const& name, std::string const& text) {
    try {
        read_triangles(MeshFile(name, text).path);
    } catch (CaseError const& error) {
        return error.what();
    }
    return "nothing";
}

void expect_in(std::string const& part, std::string const& said) {
    EXPECT_NE(said.find(part), std::string::npos) << "'" << part << "' is not in: " << said;
}

std::string const facet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";

}  // namespace

TEST(Triangles, AreTheSameFromEveryKindOfFile) {
    MeshFile const ascii("cube.stl", ascii_stl(cube())), binary("cube_binary.stl", binary_stl(cube())),
        obj("cube.obj", cube_obj());
    auto const a = read_triangles(ascii.path), b = read_triangles(binary.path), c = read_triangles(obj.path);
    ASSERT_EQ(a.size(), 12u);
    ASSERT_EQ(b.size(), 12u);
    ASSERT_EQ(c.size(), 12u);
    for (std::size_t t = 0; t < 12; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(a.corners[t][k][axis], b.corners[t][k][axis]);
                EXPECT_EQ(a.corners[t][k][axis], cube()[t][k][axis]);
            }
    EXPECT_EQ(a.place[1], 9u);  // the line of the second facet
    EXPECT_TRUE(a.in_lines);
    EXPECT_EQ(b.place[1], 2u);
    EXPECT_FALSE(b.in_lines);
}

TEST(Triangles, SayWhereAFileIsWrong) {
    expect_in("there is no such file", complaint("gone.stl", ""));
    expect_in("the file is empty", complaint("empty.stl", ""));
    expect_in("holds no triangle", complaint("hollow.stl", "solid x\nendsolid x\n"));
    expect_in("word.stl:10: 'vertx' is no word of STL",
              complaint("word.stl", "solid x\n" + facet + "facet normal 0 0 1\nvertx 0 0 0\n"));
    expect_in("number.stl:4: 'one' must be a finite number",
              complaint("number.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 one 0\n"));
    expect_in("two.stl:6: a facet ends with 2 vertices",
              complaint("two.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n"));
    expect_in("cut short", complaint("short.stl", "solid x\n" + facet));
    std::string bytes = binary_stl(cube());
    bytes.resize(bytes.size() - 7);
    expect_in("of 12 triangles it would have 684 bytes, but it has 677", complaint("cut.stl", bytes));
    expect_in("face.obj:4: a face names vertex 4, but there are 3 before it",
              complaint("face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"));
    expect_in("line.obj:3: a face has 2 corners", complaint("line.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"));
    expect_in("not from '.ply'", complaint("other.ply", "ply\n"));
}

}  // namespace coronet
