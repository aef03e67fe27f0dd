// SPDX-License-Identifier: Apache-2.0
// Where one side of an edge is divided further than the other, both meet; what merely touches stays as it is.
#include "mesh/t_vertices.hpp"

#include <cmath>
#include <numeric>

#include "support.hpp"

namespace epura::test::t_vertices_test {
namespace {

using Faces = std::vector<std::vector<int>>;

double area(const mesh::Mesh& mesh) {
  double sum = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    sum += glm::length(glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a))) / 2;
  }
  return sum;
}

/// The unit cube with a lid of these faces, and further points.
mesh::Mesh cube_with_lid(const Faces& lid, const mesh::Points& more = {}) {
  mesh::Points points = unit_cube;
  points.insert(points.end(), more.begin(), more.end());
  Faces faces = cube_quads;
  faces.erase(faces.begin() + 1);
  faces.insert(faces.end(), lid.begin(), lid.end());
  return mesh_of(points, faces);
}

TEST(TVertices, ALidDividedOnOneSideOfItsDiagonalIsClosed) {
  const mesh::Mesh mesh = cube_with_lid({{4, 5, 6}, {4, 8, 7}, {8, 6, 7}}, {{0.5, 0.5, 1}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.report.faces, 8);  // those of the file
  EXPECT_EQ(mesh.report.triangles, 14);
  EXPECT_EQ(mesh.report.bodies, 1);
  EXPECT_EQ(area(mesh), 6);
  EXPECT_EQ(mesh.report.remarks, std::vector<std::string>{"1 open edge divided where other edges end on it"});
}

TEST(TVertices, AllSidesOfATriangleMayBeDivided) {
  // The middle of a triangle, and three corners that end on its sides beside the middle.
  const mesh::Points points{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {4, -4, 0}, {8, 8, 0}, {-4, 4, 0},
                            {2, 0, 0}, {5, 3, 0}, {0, 6, 0}, {5, 0, 0},  {3, 5, 0}, {0, 1, 0}};
  const mesh::Mesh mesh = mesh_of(points, {{0, 1, 2},
                                           {0, 3, 6},
                                           {6, 3, 9},
                                           {9, 3, 1},
                                           {1, 4, 7},
                                           {7, 4, 10},
                                           {10, 4, 2},
                                           {2, 5, 8},
                                           {8, 5, 11},
                                           {11, 5, 0}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 9 + 7);
  EXPECT_EQ(mesh.report.open_edges, 6);  // the rim
  EXPECT_EQ(area(mesh), 32 + 16 + 32 + 16);
  EXPECT_EQ(mesh.report.misoriented_edges, 0);
}

// The ends of each edge lie on the other one.
TEST(TVertices, EdgesThatOverlapMeetWhereTheyDo) {
  const mesh::Mesh mesh =
      mesh_of({{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 0, 0}, {4, 0, 0}, {4, -1, 0}}, {{0, 1, 2}, {4, 3, 5}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 4);
  EXPECT_EQ(mesh.report.open_edges, 6);
  ASSERT_NE(mesh.edge_between({1, 3}), nullptr);
  EXPECT_EQ(mesh.edge_between({1, 3})->count, 2);
  EXPECT_EQ(mesh.report.bodies, 1);
}

TEST(TVertices, CornersThatMerelyTouchAnEdgeDivideNothing) {
  const mesh::Mesh mesh =
      mesh_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(mesh.report.triangles, 2);
  EXPECT_EQ(mesh.report.open_edges, 6);
  EXPECT_TRUE(mesh.report.remarks.empty());
}

// At 1000, floats are 6E-5 apart. A step of 0.01 beside an edge of 1 is not their rounding.
TEST(TVertices, MayLieOffTheEdgeByRounding) {
  for (const double off : {0.0, 6e-5, -6e-5, 0.01}) {
    const mesh::Mesh mesh = mesh_of({{1000, 0, 0}, {1004, 4, 0}, {1000, 4, 0}, {1004, 0, 0}, {1002, 2 + off, 0}},
                                    {{0, 1, 2}, {0, 3, 4}, {4, 3, 1}});
    EXPECT_EQ(mesh.report.open_edges, off == 0.01 ? 7 : 4) << off;
  }
}

// The twin faces of two bodies that touch are so small that rounding made them.
TEST(TVertices, AreNoneOfFacesThatAreGone) {
  const double step = 0x1p-22;
  const mesh::Mesh mesh =
      mesh_of({{1, 1, 0}, {1 + step, 1, 0}, {1, 1 + step, 0}, {1, 0, 0}, {2, 2, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
              {{0, 1, 2}, {0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {5, 6, 7}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 1);
  EXPECT_EQ(mesh.report.dropped_degenerate, 4);
}

// Both sides of a line are divided already, and a needle along the whole of it is open.
TEST(TVertices, NeedlesWithATipOnTheirSideAreGone) {
  const mesh::Mesh mesh = mesh_of({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 0, 0}, {2, -3, 0}},
                                  {{0, 3, 2}, {3, 1, 2}, {0, 4, 3}, {3, 4, 1}, {0, 3, 1}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 4);
  EXPECT_EQ(mesh.report.open_edges, 4);
  EXPECT_EQ(mesh.report.non_manifold_edges, 0);
}

TEST(TVertices, OfAnyNumberLieOnAnEdge) {
  const int n = 100000;
  mesh::Points points{{0, 0, 0}, {1, 1, 1}, {0, 1, 0}, {1, 0, 1}};
  Faces faces{{0, 1, 2}};
  for (int i = 0; i < n; ++i) {
    const double t = (i + 1.0) / n;
    if (i + 1 < n) points.push_back({t, t, t});
    faces.push_back({3, i + 1 < n ? 4 + i : 1, i == 0 ? 0 : 3 + i});
  }
  const mesh::Mesh mesh = mesh_of(points, faces);
  EXPECT_EQ(mesh.report.triangles, 2 * n);
  EXPECT_EQ(mesh.report.open_edges, 4);
}

}  // namespace
}  // namespace epura::test::t_vertices_test
