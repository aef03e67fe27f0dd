// SPDX-License-Identifier: Apache-2.0
// Meshes of OpenMesh in memory become drawings, with nothing but public headers.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <epura/epura.hpp>
#include <epura/openmesh.hpp>
#include <vector>

namespace epura::test::openmesh_test {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  FaceAttributes(OpenMesh::Attributes::Status);
};

template <class HalfedgeMesh>
HalfedgeMesh cube() {
  HalfedgeMesh mesh;
  std::vector<OpenMesh::VertexHandle> v;
  for (int i = 0; i < 8; ++i)
    v.push_back(mesh.add_vertex(typename HalfedgeMesh::Point(float(i & 1), float(i >> 1 & 1), float(i >> 2))));
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}})
    mesh.add_face(std::vector<OpenMesh::VertexHandle>{v[a], v[b], v[c], v[d]});
  return mesh;
}

Drawing isometric_of(const Polygons& polygons) {
  return draw(
      {.models = {{.polygons = polygons}}, .views = {{.projection = "isometric", .hidden = HiddenLines::dashed}}},
      {.plugin_path = {EPURA_TEST_PLUGINS}});
}

template <class HalfedgeMesh>
void expect_a_cube(bool single_precision) {
  const auto mesh = cube<HalfedgeMesh>();
  const Polygons polygons = polygons_of(mesh);
  EXPECT_EQ(polygons.points.size(), 8U);
  EXPECT_EQ(polygons.faces.size(), mesh.n_faces());
  EXPECT_EQ(polygons.single_precision, single_precision);
  const Drawing drawing = isometric_of(polygons);
  int visible = 0, hidden = 0;
  for (const Line& line : drawing.views().at(0).lines) {
    ++(line.visible ? visible : hidden);
    // Numbers of vertices are those of the mesh: these differ in one coordinate.
    const int differs = line.edge[0] ^ line.edge[1];
    EXPECT_TRUE(differs == 1 || differs == 2 || differs == 4) << line.edge[0] << " " << line.edge[1];
  }
  EXPECT_EQ(visible, 9);
  EXPECT_EQ(hidden, 3);
}

TEST(OpenMesh, EveryKindOfMeshBecomesADrawing) {
  expect_a_cube<OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>>(false);
  expect_a_cube<OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>>(false);
  expect_a_cube<OpenMesh::TriMesh_ArrayKernelT<>>(true);
  expect_a_cube<OpenMesh::PolyMesh_ArrayKernelT<>>(true);
}

TEST(OpenMesh, DeletedFacesAreLeftOut) {
  auto mesh = cube<OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>>();
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.delete_face(OpenMesh::FaceHandle(1), false);
  const Polygons polygons = polygons_of(mesh);
  EXPECT_EQ(polygons.points.size(), 8U);
  EXPECT_EQ(polygons.faces.size(), 5U);
  // The open top shows the upright edge that was hidden behind it.
  const Drawing drawing = isometric_of(polygons);
  const auto& lines = drawing.views().at(0).lines;
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const Line& line) {
    return line.visible && line.edge == std::array{2, 6};
  }));
}

}  // namespace
}  // namespace epura::test::openmesh_test
