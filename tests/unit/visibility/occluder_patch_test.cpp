// SPDX-License-Identifier: Apache-2.0
#include "visibility/occluder_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.hpp"
#include "visibility/visibility.hpp"

namespace epura::test::occluder_patch_test {
namespace {

struct Sheets {
  Vec2 first;  // vertex, in the world
  world::World world;
  view::ProjectedScene view;

  explicit Sheets(const Shape& shape)
      : first(shape.points[0][0], shape.points[0][1]),
        world(world_of(shape)),
        view(view::project_scene(world, from_above(), {})) {}

  // Depth in view units of a height in the world, both measured from that of a vertex.
  [[nodiscard]] double depth_above_first(double height) const {
    return view.vertices[0].depth + height * view.map.normalisation * view.map.unit;
  }

  // Of a middle in the world.
  [[nodiscard]] visibility::CellBox cell(double x, double y, double half) const {
    const double scale = view.map.normalisation * view.map.unit;
    const view::PageVertex& vertex = view.vertices[0];
    return {Vec2(vertex.x, vertex.y) + scale * (Vec2(x, y) - first), scale * Vec2(half)};
  }

  // How many triangles, in their order, make a sheet whole; 0 if all do not.
  [[nodiscard]] int whole_after(visibility::OccluderPatch& sheets) const {
    int added = 0;
    for (const view::ViewTriangle& triangle : view.triangles) {
      ++added;
      if (sheets.add(triangle)) return added;
    }
    return 0;
  }

  [[nodiscard]] int whole_after(const visibility::CellBox& cell) const {
    visibility::OccluderPatch sheets(view, cell);
    return whole_after(sheets);
  }
};

// Corners -2 to 2, around a vertex in the middle that lies higher.
Shape roof(double height) {
  return {{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {0, 0, height}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
          {}};
}

TEST(OccluderPatch, NeedsAllTrianglesThatReachIntoTheCell) {
  const Sheets roofed(roof(1));
  EXPECT_EQ(roofed.whole_after(roofed.cell(0, 0, 0.5)), 4);      // around the middle
  EXPECT_EQ(roofed.whole_after(roofed.cell(1, -1, 0.25)), 2);    // across one side
  EXPECT_EQ(roofed.whole_after(roofed.cell(0, -1, 0.25)), 1);    // within one triangle
  EXPECT_EQ(roofed.whole_after(roofed.cell(-1.9, 0, 0.25)), 0);  // over the border
  EXPECT_EQ(roofed.whole_after(roofed.cell(5, 5, 0.25)), 0);     // beside
}

TEST(OccluderPatch, LiesAsDeepAsTheDeepestPlaneInTheCell) {
  const Sheets roofed(roof(1));
  visibility::OccluderPatch sheets(roofed.view, roofed.cell(0, 0, 0.5));
  ASSERT_EQ(roofed.whole_after(sheets), 4);
  // The planes rise by 1/2 towards the middle; in the cell, the lowest place of each is half a unit beyond the top.
  EXPECT_LT(sheets.depth(), roofed.depth_above_first(0.75));
  EXPECT_NEAR(sheets.depth(), roofed.depth_above_first(0.75), 1e-6);
}

// Beside the top of a roof, the plane that falls away from it lies deepest, whichever comes first.
TEST(OccluderPatch, LiesAsDeepAsTheDeepestOfItsPlanes) {
  for (int first = 0; first < 4; ++first) {
    Shape shape = roof(1);
    std::rotate(shape.faces.begin(), shape.faces.begin() + first, shape.faces.end());
    const Sheets roofed(shape);
    visibility::OccluderPatch sheets(roofed.view, roofed.cell(0.3, 0, 0.5));
    ASSERT_EQ(roofed.whole_after(sheets), 4) << first;
    EXPECT_NEAR(sheets.depth(), roofed.depth_above_first(0.6), 1e-6) << first;
  }
}

TEST(OccluderPatch, FoldsAndGapsLeaveItOpen) {
  Shape shape{{{0, -2, 0}, {0, 2, 0}, {2, 0, 0}, {3, 0, 1}}, {{0, 1, 2}, {0, 1, 3}}, {}};
  const Sheets folded(shape);
  EXPECT_EQ(folded.whole_after(folded.cell(0, 0, 0.2)), 0);
  shape.points[3] = {-3, 0, 1};
  const Sheets ridge(shape);
  EXPECT_EQ(ridge.whole_after(ridge.cell(0, 0, 0.2)), 2);
  shape.points.push_back({-0.1, -2, 0});
  shape.faces[1][0] = 4;
  const Sheets torn(shape);
  EXPECT_EQ(torn.whole_after(torn.cell(0, 0, 0.2)), 0);
}

}  // namespace
}  // namespace epura::test::occluder_patch_test
