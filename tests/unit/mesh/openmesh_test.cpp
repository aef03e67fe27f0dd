// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: whatever walks the half-edges of a mesh.
#include "mesh/openmesh.hpp"

#include <algorithm>
#include <filesystem>

#include "support.hpp"

namespace epura::openmesh_test {
namespace {

using test::mesh_of;

void expect_valid_vertices(const mesh::Mesh& mesh, const mesh::HalfedgeMesh& made) {
  const mesh::Surface& surface = made.surface;
  ASSERT_EQ(made.vertex_of.size(), surface.n_vertices());
  for (const auto vertex : surface.vertices()) {
    const int original = made.vertex_of[static_cast<std::size_t>(vertex.idx())];
    ASSERT_LT(original, mesh.report.vertices);
    ASSERT_TRUE(original == vertex.idx() || vertex.idx() >= mesh.report.vertices);
    if (surface.is_isolated(vertex)) continue;
    ASSERT_TRUE(surface.is_manifold(vertex)) << vertex.idx();
    const auto& [x, y, z] = mesh.points[static_cast<std::size_t>(original)];
    ASSERT_EQ(surface.point(vertex), OpenMesh::Vec3d(x, y, z));
    bool at_border = false;
    for (const auto outgoing : surface.voh_range(vertex)) {
      ASSERT_EQ(surface.from_vertex_handle(outgoing), vertex);
      at_border = at_border || surface.is_boundary(outgoing);
    }
    ASSERT_EQ(surface.is_boundary(vertex), at_border);
  }
}

void expect_valid_halfedges(const mesh::Surface& surface) {
  for (const auto halfedge : surface.halfedges()) {
    const auto next = surface.next_halfedge_handle(halfedge);
    ASSERT_TRUE(next.is_valid());
    ASSERT_EQ(surface.prev_halfedge_handle(next), halfedge);
    ASSERT_EQ(surface.from_vertex_handle(next), surface.to_vertex_handle(halfedge));
    ASSERT_EQ(surface.face_handle(next), surface.face_handle(halfedge));
  }
}

// Circulators begin at the first corner.
void expect_faces_of(const mesh::Mesh& mesh, const mesh::HalfedgeMesh& made) {
  ASSERT_EQ(made.surface.n_faces(), mesh.polygon.size());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::vector<int> corners;
    for (const auto vertex : made.surface.fv_range(OpenMesh::FaceHandle(t)))
      corners.push_back(made.vertex_of[static_cast<std::size_t>(vertex.idx())]);
    const auto expected = mesh.triangle(t);
    ASSERT_EQ(corners, std::vector<int>(expected.begin(), expected.end())) << t;
  }
}

/// With what OpenMesh's algorithms rely on.
mesh::HalfedgeMesh valid_halfedges_of(const mesh::Mesh& mesh) {
  mesh::HalfedgeMesh made = mesh::to_openmesh(mesh);
  expect_faces_of(mesh, made);
  expect_valid_vertices(mesh, made);
  expect_valid_halfedges(made.surface);
  // Every edge of the mesh is there once, but for those that are cut open, and for wires.
  std::size_t of_triangles = 0, cut_open = 0;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    of_triangles += edge.count > 0 ? 1U : 0U;
    cut_open += edge.count > 2 ? static_cast<std::size_t>(edge.count - 1) : 0;
  }
  EXPECT_EQ(made.surface.n_edges(), of_triangles + cut_open + static_cast<std::size_t>(mesh.report.misoriented_edges));
  return made;
}

TEST(OpenMesh, ACubeStaysWhole) {
  const mesh::HalfedgeMesh made = valid_halfedges_of(mesh_of(test::unit_cube, test::cube_quads));
  EXPECT_EQ(made.surface.n_edges(), 18u);
  EXPECT_EQ(made.surface.n_vertices(), 8u);
}

TEST(OpenMesh, ThreeTrianglesOnOneEdgeAreCutApart) {
  const mesh::HalfedgeMesh made = valid_halfedges_of(
      mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}));
  EXPECT_EQ(made.surface.n_vertices(), 9u);  // 5 and two copies each of vertices 0 and 1
  EXPECT_EQ(made.surface.n_edges(), 9u);
  EXPECT_EQ(made.vertex_of, (std::vector<int>{0, 1, 2, 3, 4, 0, 1, 1, 0}));
}

TEST(OpenMesh, AFlippedFaceIsCutOut) {
  auto quads = test::cube_quads;
  std::reverse(quads[1].begin(), quads[1].end());
  const mesh::HalfedgeMesh made = valid_halfedges_of(mesh_of(test::unit_cube, quads));
  EXPECT_EQ(made.surface.n_edges(), 22u);
  EXPECT_EQ(made.surface.n_vertices(), 12u);
}

TEST(OpenMesh, ConesThatMeetInAVertexAreCutApart) {
  const mesh::HalfedgeMesh made =
      valid_halfedges_of(mesh_of({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}},
                                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 5, 4}, {0, 6, 5}, {0, 4, 6}}));
  EXPECT_EQ(made.surface.n_vertices(), 8u);
  EXPECT_EQ(made.vertex_of[7], 0);
}

TEST(OpenMesh, VerticesWithoutFacesAreIsolated) {
  const mesh::HalfedgeMesh made =
      valid_halfedges_of(mesh_of({{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 3}}));
  EXPECT_TRUE(made.surface.is_isolated(OpenMesh::VertexHandle(1)));
  EXPECT_EQ(mesh::to_openmesh(mesh_of({}, {})).surface.n_vertices(), 0u);
}

TEST(OpenMesh, TakesWhateverFilesHold) {
  int models = 0;
  for (const char* folder : {EPURA_TEST_SAMPLES "/models", EPURA_TEST_GOLDEN "/models"})
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      SCOPED_TRACE(file.path());
      const mesh::HalfedgeMesh made = valid_halfedges_of(mesh::read_mesh(file.path()));
      ++models;
      // The band with one side has one seam, which has two sides.
      if (file.path().stem() != "moebius") continue;
      EXPECT_EQ(made.surface.n_vertices(), made.vertex_of.size());
      EXPECT_EQ(std::count_if(made.vertex_of.begin(), made.vertex_of.end(),
                              [&](int v) { return std::count(made.vertex_of.begin(), made.vertex_of.end(), v) > 1; }),
                4);
    }
  EXPECT_GT(models, 10);
}

}  // namespace
}  // namespace epura::openmesh_test
