// SPDX-License-Identifier: Apache-2.0
// What the tests of this stage share: soups by hand, files in a fresh folder, the laws of a valid mesh.
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

inline mesh::Soup make_soup(mesh::Points points, const std::vector<std::vector<int>>& faces) {
  mesh::Soup soup;
  soup.points = std::move(points);
  soup.format = "obj";
  for (const auto& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_face();
  }
  return soup;
}

inline mesh::Mesh mesh_of(mesh::Points points, const std::vector<std::vector<int>>& faces) {
  return mesh::build_mesh(make_soup(std::move(points), faces), "test");
}

/// What `action` throws, as "where | sentence | hint"; empty if nothing.
inline std::string words_of_error(const std::function<void()>& action) {
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

inline void expect_valid(const mesh::Mesh& mesh) {
  const auto triangles = static_cast<std::size_t>(mesh.report.triangles);
  ASSERT_EQ(mesh.corners.size(), 3 * triangles);
  ASSERT_EQ(mesh.polygon.size(), triangles);
  ASSERT_EQ(mesh.body.size(), triangles);
  ASSERT_EQ(mesh.points.size(), static_cast<std::size_t>(mesh.report.vertices));
  std::size_t sides = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const mesh::MeshEdge& edge = mesh.edges[e];
    ASSERT_LT(edge.vertex[0], edge.vertex[1]);
    ASSERT_TRUE(e == 0 || mesh.edges[e - 1].vertex < edge.vertex);
    const auto around = mesh.triangles_of(edge);
    ASSERT_TRUE(std::is_sorted(around.begin(), around.end()));
    for (const int triangle : around) {
      const auto corners = mesh.triangle(triangle);
      for (const int vertex : edge.vertex) ASSERT_NE(std::find(corners.begin(), corners.end(), vertex), corners.end());
    }
    sides += around.size();
  }
  ASSERT_EQ(sides, 3 * mesh.polygon.size());
}

inline const mesh::Points unit_cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline const std::vector<std::vector<int>> cube_quads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

}  // namespace epura::test
