// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "at_length.hpp"
#include "base/nearest.hpp"
#include "skewed_torus.hpp"
#include "visibility/folds.hpp"

namespace epura::test::clear_contours_test {
namespace {

// The places on the visible contour of the torus, of about 7000, that have no visible line within a distance.
int places_without_ink(const world::World& world, bool looks_behind_facets, double distance) {
  constexpr double min_bend = 0.01;
  const Vec3 towards(1, -1, 1);
  view::ProjectedScene view = view::project_scene(world, orthographic(towards), {});
  edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  if (looks_behind_facets) visibility::find_clear_contours(world, view, drawn);
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  const view::PaperMap paper{1, Vec2(0)};
  const Mat4 to_page = view::world_to_page(view, paper);
  std::vector<std::array<Vec2, 2>> lines;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    hidden.visit_parts(e, [&](double from, double to, bool visible) {
      const auto at = [&](double s) { return drawing::position_on_paper(view, paper, drawn.edges[e], s); };
      if (visible) lines.push_back({at(from), at(to)});
    });
  const double near = distance * view.map.normalisation;
  int without = 0;
  for (const Vec3& p : visible_contour_of_torus(towards, min_bend)) {
    const Vec2 place = Vec2(to_page * Vec4(p, 1));
    double nearest = HUGE_VAL;
    for (const auto& line : lines) nearest = std::min(nearest, distance_to_segment(place, line[0], line[1]));
    if (nearest > near) ++without;
  }
  return without;
}

// Skewed facets hide some of the contour of their surface.
TEST(ClearContours, HaveNoGaps) {
  for (const int around : {24, 36, 48}) {
    if (around == 48 && !test::at_length()) continue;
    const world::World world = recognised(world_of(torus(around, 5 * around / 2, 0.3)));
    ASSERT_NE(world.models[0].part, nullptr);
    ASSERT_EQ(world.models[0].part->faces.size(), 1U);
    const double distance = 60.0 / around / around;
    EXPECT_GT(places_without_ink(world, false, distance), 100);
    EXPECT_EQ(places_without_ink(world, true, distance), 0);
  }
}

// What is in front of the torus hides it.
TEST(ClearContours, AreHiddenByWhatIsInFront) {
  Shape both = torus(36, 90, 0.3);
  const auto first = static_cast<int>(both.points.size());
  const Shape plate = box({-40, -40, 60}, {40, 40, 61});
  both.points.insert(both.points.end(), plate.points.begin(), plate.points.end());
  for (auto face : plate.faces) {
    for (int& corner : face) corner += first;
    both.faces.push_back(face);
  }
  const world::World world = recognised(world_of(both));
  view::ProjectedScene view = view::project_scene(world, from_above(), {});
  edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  visibility::find_clear_contours(world, view, drawn);
  EXPECT_GT(drawn.clear_contours.size(), 0U);
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    if (world.points[drawn.edges[e].vertex[0]].z < 50)
      hidden.visit_parts(e, [&](double, double, bool visible) { EXPECT_FALSE(visible) << e; });
}

// Cells of the search that a facet covers hide nothing of a contour in front of which the facet does not count.
TEST(ClearContours, AreFoundInWhateverCells) {
  Shape fine = uv_sphere(160, 320);
  for (auto& p : fine.points) p = {20 * p[0], 20 * p[1], 20 * p[2] - 80};
  const world::World world = recognised(world_of(std::vector<Shape>{torus(24, 60, 0.3), fine}));
  view::ProjectedScene view = view::project_scene(world, orthographic({1, -1, 1}), {});
  edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  visibility::find_clear_contours(world, view, drawn);
  EXPECT_GT(drawn.clear_contours.size(), 10U);
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  const visibility::HiddenSpans directly = visibility::find_hidden_directly(world, view, drawn);
  EXPECT_EQ(hidden.first, directly.first);
  EXPECT_EQ(hidden.spans, directly.spans);
  EXPECT_FALSE(hidden.by_facets.empty());
}

}  // namespace
}  // namespace epura::test::clear_contours_test
