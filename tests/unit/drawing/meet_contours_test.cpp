// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "drawing/settled_pieces.hpp"
#include "shapes.hpp"

namespace epura::test::meet_contours_test {
namespace {

using drawing::Piece;

// Two contours whose first halves end in one point of the mesh, and are drawn beside it: 0.1 above and 0.2 to the
// right.
TEST(MeetContours, LetsTwoThatEndTogetherMeetHalfWay) {
  const world::World world = world_of(box({0, 0, 0}, {1, 1, 1}));
  view::ProjectedScene view;
  for (const Vec2& p : {Vec2(0, 0), Vec2(10, 0), Vec2(5, -5), Vec2(5, 5)}) view.vertices.push_back({p.x, p.y, 0, 1});
  edges::FeatureEdges drawn;
  for (const int first : {0, 2})
    drawn.edges.push_back({{first, first + 1}, {0, 1}, EdgeKind::contour, 0, first, -1, {first, first + 1}});
  std::vector<Piece> pieces{{{0, 0.1}, {5, 0.1}, true, true, EdgeKind::contour, 0, {0, 0.5}},
                            {{5.2, -5}, {5.2, 0}, true, true, EdgeKind::contour, 1, {0, 0.5}}};
  drawing::meet_contours({world, view, drawn, visibility::nothing_hidden(drawn)}, {1, Vec2(0)}, 0.01, pieces);
  for (const Piece& piece : pieces) {
    EXPECT_NEAR(piece.to.x, 5.1, 1e-12);
    EXPECT_NEAR(piece.to.y, 0.05, 1e-12);
  }
  EXPECT_EQ(pieces[0].from, Vec2(0, 0.1));
  EXPECT_EQ(pieces[1].from, Vec2(5.2, -5));
}

}  // namespace
}  // namespace epura::test::meet_contours_test
