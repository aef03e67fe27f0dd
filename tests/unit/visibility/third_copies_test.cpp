// SPDX-License-Identifier: Apache-2.0
#include "visibility/third_copies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.hpp"

namespace epura::test::third_copies_test {
namespace {

const Shape triangle{{{0, 0, 0}, {3, 0, 1}, {0, 2, 2}}, {{0, 1, 2}}, {}};

std::vector<int> others(const std::vector<Shape>& shapes) {
  const Result r = draw(world_of(shapes), from_above());
  return visibility::ThirdCopies(r.world, r.view, {}).others();
}

TEST(ThirdCopies, AreAllButTwoOfThoseInOnePlace) {
  const Shape beside = triangle.moved(1, 0, 0), below = triangle.moved(0, 0, -1);
  EXPECT_EQ(others({triangle, beside, triangle, below, triangle, beside, triangle, below}),
            (std::vector<int>{0, 1, 2, 3, 5, 7}));
}

TEST(ThirdCopies, HaveTheirCornersInTheSameOrder) {
  Shape turned = triangle, renumbered = triangle;
  std::rotate(turned.faces[0].begin(), turned.faces[0].begin() + 1, turned.faces[0].end());
  std::rotate(renumbered.points.begin(), renumbered.points.begin() + 1, renumbered.points.end());
  renumbered.faces[0] = {2, 0, 1};
  EXPECT_EQ(others({triangle, triangle, turned, renumbered}), (std::vector<int>{0, 1, 2, 3}));
}

TEST(ThirdCopies, AreFoundAroundTheirCorners) {
  const Result r = draw(world_of(std::vector<Shape>(4, box({0, 0, 0}, {1, 2, 3}))), from_above());
  const visibility::ThirdCopies copies(r.world, r.view, {});
  EXPECT_EQ(copies.others().size(), 2U * 12);
  EXPECT_EQ(copies.other_edges(r.view, r.drawn.edges, {}).size(), r.drawn.edges.size() / 2);
  for (int v = 0; v < 4 * 8; ++v) {
    std::vector<int> expected;
    for (int t = 2 * 12; t < 4 * 12; ++t) {
      const auto& corners = r.view.triangles[t].vertex;
      if (std::find(corners.begin(), corners.end(), v) != corners.end()) expected.push_back(t);
    }
    const auto around = copies.around(v);
    EXPECT_EQ(std::vector<int>(around.begin(), around.end()), expected) << "vertex " << v;
  }
}

// A face that is nearer than contact hides an edge that begins at its corner. Its copies, which touch the edge, do not.
TEST(ThirdCopies, HideEdgesThatBeginAtTheirCorners) {
  const Shape shape{{{0, 0, 0}, {1, -1, 1e-9}, {1, 1, 1e-9}, {0.9, 0, 0}, {0.5, 0.2, -1}}, {{0, 1, 2}, {0, 3, 4}}, {}};
  const Result r = draw(world_of(std::vector<Shape>(4, shape)), from_above());
  int found = 0;
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e) {
    const edges::FeatureEdge& edge = r.drawn.edges[e];
    if (edge.vertex[0] % 5 != 0 || edge.vertex[1] % 5 != 3) continue;
    ++found;
    ASSERT_EQ(r.hidden.first[e + 1] - r.hidden.first[e], 1U) << "model " << edge.model;
    EXPECT_EQ(r.hidden.spans[r.hidden.first[e]], (std::array<double, 2>{0, 1})) << "model " << edge.model;
  }
  EXPECT_EQ(found, 4);
}

}  // namespace
}  // namespace epura::test::third_copies_test
