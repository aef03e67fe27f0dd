// SPDX-License-Identifier: Apache-2.0
#include "mesh/edge_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace epura::test::edge_table_test {
namespace {

mesh::EdgeTable table_of(const std::vector<int>& corners, int vertices) {
  std::vector<int> polygon(corners.size() / 3);
  std::iota(polygon.begin(), polygon.end(), 0);
  return mesh::make_edge_table(corners, polygon, vertices);
}

bool has_equal(const std::vector<int>& corners, int vertices) {
  return mesh::has_equal_triangles(table_of(corners, vertices), corners);
}

TEST(EdgeTable, WiresAreEdgesWhetherTrianglesHaveThemOrNot) {
  mesh::EdgeTable table = table_of({2, 3, 4}, 9);
  mesh::add_wires(table, std::vector<std::array<int, 2>>{{8, 7}, {4, 3}, {0, 1}, {5, 5}, {7, 8}, {3, 0}});
  std::vector<std::array<int, 2>> edges;
  std::vector<int> counts;
  std::vector<bool> wires;
  for (const mesh::MeshEdge& edge : table.edges) {
    edges.push_back(edge.vertex);
    counts.push_back(edge.count);
    wires.push_back(edge.wire);
    EXPECT_EQ(table.halfedges_of(edge).size(), static_cast<std::size_t>(edge.count));
  }
  EXPECT_EQ(edges, (std::vector<std::array<int, 2>>{{0, 1}, {0, 3}, {2, 3}, {2, 4}, {3, 4}, {7, 8}}));
  EXPECT_EQ(counts, (std::vector<int>{0, 0, 1, 1, 1, 0}));
  EXPECT_EQ(wires, (std::vector<bool>{true, true, false, false, true, true}));
}

TEST(EdgeTable, HoldsEveryHalfedgeAtItsEdge) {
  std::mt19937 random(1);
  const int vertices = 9000;  // more than one thread takes at once
  std::vector<int> corners;
  for (int t = 0; t < 20000; ++t) {
    const int a = static_cast<int>(random() % vertices);
    corners.insert(corners.end(), {a, (a + 1 + t % 3) % vertices, (a + 4 + t % 5) % vertices});
  }
  std::map<std::array<int, 2>, std::vector<int>> expected;
  for (int h = 0; h < static_cast<int>(corners.size()); ++h) {
    const auto [low, high] = std::minmax({corners[h], corners[mesh::next_in_triangle(h)]});
    expected[{low, high}].push_back(h);
  }
  const mesh::EdgeTable table = table_of(corners, vertices);
  ASSERT_EQ(table.edges.size(), expected.size());
  auto next = expected.begin();
  for (const mesh::MeshEdge& edge : table.edges) {
    const auto halfedges = table.halfedges_of(edge);
    EXPECT_EQ(edge.vertex, next->first);
    EXPECT_EQ(std::vector<int>(halfedges.begin(), halfedges.end()), next->second);
    ++next;
  }
}

TEST(EdgeTable, TellsOfEqualTriangles) {
  EXPECT_FALSE(has_equal({0, 1, 2, 2, 1, 3}, 4));
  EXPECT_TRUE(has_equal({0, 1, 2, 1, 2, 0}, 3)) << "another start";
  EXPECT_TRUE(has_equal({0, 1, 2, 2, 1, 0}, 3)) << "another direction";
  EXPECT_FALSE(has_equal({0, 1, 2, 0, 1, 3, 1, 0, 4}, 5)) << "three on one edge";
  EXPECT_TRUE(has_equal({0, 1, 2, 0, 1, 3, 1, 0, 2}, 4)) << "not one after the other";
}

}  // namespace
}  // namespace epura::test::edge_table_test
