// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: the most common files for makers of parts, and their cracks.
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "support.hpp"

namespace epura::stl_test {
namespace {

using test::binary_stl;
using test::expect_valid;
using test::Triangle;
using test::words_of_error;

std::vector<Triangle> cube() {
  std::vector<Triangle> triangles;
  for (const auto& q : test::cube_quads)
    for (const auto& corners : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t a = 0; a < 3; ++a)
          triangle[k][a] = static_cast<float>(test::unit_cube[static_cast<std::size_t>(corners[k])][a]);
      triangles.push_back(triangle);
    }
  return triangles;
}

mesh::Mesh mesh_of(std::string_view bytes) { return mesh::build_mesh(mesh::read_stl(bytes, "m.stl"), "m.stl"); }

TEST(Stl, BinaryCubeIsWelded) {
  const mesh::Mesh mesh = mesh_of(binary_stl(cube()));
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.vertices, 8);
  EXPECT_EQ(mesh.report.triangles, 12);
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.report.welded_vertices, 0);
  EXPECT_TRUE(mesh.report.single_precision);
  EXPECT_EQ(mesh.triangle(0), (std::array<int, 3>{0, 1, 2}));  // numbered in order of appearance
  EXPECT_EQ(mesh.point(1), Vec3(0, 1, 0));
}

TEST(Stl, BinaryMayCallItselfSolid) {
  EXPECT_EQ(mesh_of(binary_stl(cube(), "solid facet normal endsolid")).report.triangles, 12);
}

TEST(Stl, BytesBehindTheLastTriangleAreNoted) {
  const mesh::Mesh mesh = mesh_of(binary_stl(cube()) + "tail");
  EXPECT_EQ(mesh.report.triangles, 12);
  EXPECT_EQ(mesh.report.notes, (std::vector<std::string>{"ignored 4 bytes after the last triangle"}));
}

TEST(Stl, TruncatedBinaryNamesTheByte) {
  const std::string bytes = binary_stl(cube());
  EXPECT_EQ(words_of_error([&] { mesh::read_stl(std::string_view(bytes).substr(0, 200), "m.stl"); }),
            "m.stl: byte 200 | m.stl: byte 200: the file ends at triangle 3 of 12 | is the file complete?");
  EXPECT_EQ(words_of_error([&] { mesh::read_stl(std::string_view(bytes).substr(0, 50), "m.stl"); }),
            "m.stl: byte 50 | m.stl: byte 50: the file ends inside the header of a binary STL | is the file complete?");
}

TEST(Stl, CornersThatDifferInTheLastBitsAreJoined) {
  auto triangles = cube();
  // Each triangle of the top gets its own rounding of the coordinate 1.
  for (std::size_t t = 2; t < 4; ++t)
    for (auto& corner : triangles[t]) corner[2] = std::nextafter(1.0f, t == 2 ? 2.0f : 0.0f);
  const mesh::Mesh mesh = mesh_of(binary_stl(triangles));
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.vertices, 8);
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.report.welded_vertices, 6);
  EXPECT_GT(mesh.report.weld_distance, 0x1p-25);
  EXPECT_LE(mesh.report.weld_distance, 0x1p-22);
}

TEST(Stl, WiderCracksStayOpen) {
  auto triangles = cube();
  for (auto& corner : triangles[2]) corner[2] = 1.0001f;
  const mesh::Mesh mesh = mesh_of(binary_stl(triangles));
  EXPECT_EQ(mesh.report.welded_vertices, 0);
  EXPECT_EQ(mesh.report.open_edges, 6);
}

TEST(Stl, TinyFacesSurvive) {
  // A triangle as small as the tolerance, far from another that sets the tolerance.
  const float e = 0x1p-23f;
  const std::vector<Triangle> triangles{{{{{0, 0, 0}}, {{e, 0, 0}}, {{0, e, 0}}}},
                                        {{{{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 1}}}}};
  const mesh::Mesh mesh = mesh_of(binary_stl(triangles));
  EXPECT_EQ(mesh.report.triangles, 2);
  EXPECT_EQ(mesh.report.vertices, 6);
}

TEST(Stl, ManyCornersAtOnePlaceAreJoined) {
  // The tip of a cone, computed anew for each of its triangles.
  constexpr int n = 1000;
  std::string text = "solid cone\n";
  for (int i = 0; i < n; ++i) {
    const auto rim = [](int k) {
      const double angle = 2 * std::numbers::pi * (k % n) / n;
      return "vertex " + format_number(std::cos(angle)) + " " + format_number(std::sin(angle)) + " 0\n";
    };
    const std::string tip = "vertex " + format_number(1e-12 * (i * 389 % n)) + " " + format_number(1e-12 * i) + " 1\n";
    text += "facet normal 0 0 1\nouter loop\n" + tip + rim(i) + rim(i + 1) + "endloop\nendfacet\n";
  }
  const mesh::Mesh mesh = mesh_of(text);
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.vertices, n + 1);
  EXPECT_EQ(mesh.report.open_edges, n);
  EXPECT_EQ(mesh.report.welded_vertices, n - 1);
}

TEST(Stl, FacesThatBecomeEqualAreDropped) {
  const float one = std::nextafter(1.0f, 2.0f);
  const std::vector<Triangle> triangles{{{{{0, 0, 1}}, {{1, 0, 1}}, {{0, 1, 1}}}},
                                        {{{{0, 0, one}}, {{1, 0, one}}, {{0, 1, one}}}}};
  const mesh::Mesh mesh = mesh_of(binary_stl(triangles));
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 1);
  EXPECT_EQ(mesh.report.faces, 1);
  EXPECT_EQ(mesh.report.dropped_duplicates, 1);
}

TEST(Stl, TextInAnyCaseWithSeveralSolids) {
  const mesh::Mesh mesh = mesh_of(
      "solid lower part # of 2\r\nFACET NORMAL nan nan nan\r\nOuter Loop\r\nvertex 0 0 0\r\nVERTEX 1e0 +0 0\r\n"
      "vertex 0 1. -0\r\nendloop\r\nendfacet\r\nendsolid lower part\r\n"
      "solid\rfacet normal 0 0 1 outer loop vertex 0 0 5 vertex 1 0 5 vertex 1 1 5 vertex 0 1 5 endloop endfacet\r");
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.faces, 2);
  EXPECT_EQ(mesh.report.triangles, 3);
  EXPECT_EQ(mesh.report.body_names, (std::vector<std::string>{"lower part # of 2", "solid 2"}));
  EXPECT_EQ(mesh.body, (std::vector<int>{0, 1, 1}));
}

TEST(Stl, TextErrorsNameTheLine) {
  const auto error = [](const std::string& body) {
    return words_of_error([&] { mesh::read_stl("solid s\nfacet normal 0 0 1\n" + body, "m.stl"); });
  };
  EXPECT_EQ(error("vertex 0 0\n"), "m.stl:3 | m.stl:3: the z coordinate is missing | ");
  EXPECT_EQ(error("vertex 0 0 zero\n"), "m.stl:3 | m.stl:3: 'zero' is not a number, or too large | ");
  EXPECT_EQ(error("vertex 0 0 0\nvertx 1 2 3"), "m.stl:4 | m.stl:4: 'vertx' does not belong in a text STL | ");
  EXPECT_EQ(error("vertex 0 0 0\n"), "m.stl:4 | m.stl:4: the file ends inside a facet | is the file complete?");
  EXPECT_EQ(error("facet\n"), "m.stl:3 | m.stl:3: a facet begins inside a facet | ");
  EXPECT_EQ(error("endfacet\nvertex 0 0 0\n"), "m.stl:4 | m.stl:4: a vertex outside a facet | ");
}

}  // namespace
}  // namespace epura::stl_test
