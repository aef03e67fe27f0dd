// SPDX-License-Identifier: Apache-2.0
// What the tests of this stage share: soups by hand, files in a fresh folder, the laws of a valid surface.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "folder.hpp"
#include "mesh/build.hpp"
#include "mesh/read.hpp"

namespace epura::test {

inline Soup make_soup(Points points, const std::vector<std::vector<int>>& faces) {
  Soup soup;
  soup.points = std::move(points);
  soup.format = "obj";
  for (const auto& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_face();
  }
  return soup;
}

inline Mesh mesh_of(Points points, const std::vector<std::vector<int>>& faces) {
  return build_mesh(make_soup(std::move(points), faces), "test");
}

/// What `action` throws, as "where | sentence | hint"; empty if nothing.
inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.where() + " | " + error.what() + " | " + error.hint();
  }
  return {};
}

inline void append(std::string& bytes, auto value, std::endian order = std::endian::little) {
  auto raw = std::bit_cast<std::array<char, sizeof(value)>>(value);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.begin(), raw.end());
}

using Triangle = std::array<std::array<float, 3>, 3>;

inline std::string binary_stl(const std::vector<Triangle>& triangles, std::string header = "made by a test") {
  header.resize(80);
  append(header, static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    header.append(12, '\0');
    for (const auto& corner : triangle)
      for (const float x : corner) append(header, x);
    header.append(2, '\0');
  }
  return header;
}

/// What OpenMesh's algorithms rely on.
inline void expect_valid_surface(const Mesh& mesh) {
  const Surface& surface = mesh.surface;
  const auto triangles = static_cast<std::size_t>(mesh.report.triangles);
  ASSERT_EQ(surface.n_faces(), triangles);
  ASSERT_EQ(mesh.polygon.size(), triangles);
  ASSERT_EQ(mesh.body.size(), triangles);
  ASSERT_EQ(mesh.vertex_of.size(), surface.n_vertices());
  for (const auto vertex : surface.vertices()) {
    const int original = mesh.vertex_of[static_cast<std::size_t>(vertex.idx())];
    ASSERT_LT(original, mesh.report.vertices);
    ASSERT_TRUE(original == vertex.idx() || vertex.idx() >= mesh.report.vertices);
    if (surface.is_isolated(vertex)) continue;
    ASSERT_TRUE(surface.is_manifold(vertex)) << vertex.idx();
    ASSERT_EQ(surface.point(vertex), mesh.point(original));
    bool at_border = false;
    for (const auto outgoing : surface.voh_range(vertex)) {
      ASSERT_EQ(surface.from_vertex_handle(outgoing), vertex);
      at_border = at_border || surface.is_boundary(outgoing);
    }
    ASSERT_EQ(surface.is_boundary(vertex), at_border);
  }
  for (const auto halfedge : surface.halfedges()) {
    const auto next = surface.next_halfedge_handle(halfedge);
    ASSERT_TRUE(next.is_valid());
    ASSERT_EQ(surface.prev_halfedge_handle(next), halfedge);
    ASSERT_EQ(surface.from_vertex_handle(next), surface.to_vertex_handle(halfedge));
    ASSERT_EQ(surface.face_handle(next), surface.face_handle(halfedge));
  }
}

inline void expect_valid_edges(const Mesh& mesh) {
  std::size_t sides = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const MeshEdge& edge = mesh.edges[e];
    ASSERT_LT(edge.vertex[0], edge.vertex[1]);
    ASSERT_TRUE(e == 0 || mesh.edges[e - 1].vertex < edge.vertex);
    const auto around = mesh.triangles_of(edge);
    ASSERT_TRUE(std::is_sorted(around.begin(), around.end()));
    for (const int triangle : around) {
      const auto corners = mesh.corners(triangle);
      for (const int vertex : edge.vertex) ASSERT_NE(std::find(corners.begin(), corners.end(), vertex), corners.end());
    }
    sides += around.size();
  }
  ASSERT_EQ(sides, 3 * mesh.polygon.size());
}

inline void expect_valid(const Mesh& mesh) {
  expect_valid_surface(mesh);
  expect_valid_edges(mesh);
}

inline const Points unit_cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline const std::vector<std::vector<int>> cube_quads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

}  // namespace epura::test
