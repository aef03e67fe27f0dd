// SPDX-License-Identifier: Apache-2.0
#include "annotations/limit_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/nearest.hpp"

namespace epura::test::limit_lines_test {
namespace {

double apart(const sheet::Stroke& one, const sheet::Stroke& other) {
  double least = HUGE_VAL;
  const auto add = [&least](const sheet::Stroke& points, const sheet::Stroke& lines) {
    for (const Vec2& p : points.points)
      for (std::size_t i = 0; i + 1 < lines.points.size(); ++i)
        least = std::min(least, distance_to_segment(p, lines.points[i], lines.points[i + 1]));
  };
  add(one, other);
  add(other, one);
  return least;
}

// On both sides of a gap of 6 mm, whatever the heights of the view there, and the widths of its lines.
TEST(LimitLines, HaveZigzagsThatDoNotTouch) {
  for (const double narrow : {0.18, 0.25, 0.35})
    for (const double height : {1.0, 4.0, 17.0, 30.0, 200.0})
      for (const double taller : {1.0, 1.3, 2.0}) {
        drawing::ViewDrawing view;
        view.shown.limits = {{{50, 100 - height / 2}, {50, 100 + height / 2}, false},
                             {{56, 100 - taller * height / 2}, {56, 100 + taller * height / 2}, false}};
        const auto layer = sheet::limit_lines(view, {2 * narrow, narrow});
        ASSERT_TRUE(layer);
        ASSERT_EQ(layer->strokes.size(), 2U);
        EXPECT_GT(apart(layer->strokes[0], layer->strokes[1]), 1) << narrow << " " << height << " " << taller;
        for (std::size_t i = 0; i < 2; ++i) {
          const std::vector<Vec2>& points = layer->strokes[i].points;
          EXPECT_DOUBLE_EQ(points.front().x, view.shown.limits[i].from.x);
          EXPECT_DOUBLE_EQ(points.front().y, view.shown.limits[i].from.y - 3);
          EXPECT_DOUBLE_EQ(points.back().y, view.shown.limits[i].to.y + 3);
          for (std::size_t k = 1; k < points.size(); ++k) EXPECT_GE(points[k].y, points[k - 1].y);
        }
      }
}

TEST(LimitLines, OfRevolvedSectionsHaveAnAxisPastTheirOutlines) {
  drawing::ViewDrawing view;
  view.cuts.revolved = {{{{{10, 10}, {20, 10}, {20, 40}, {10, 40}}}, {Vec2(15, 10), Vec2(15, 40)}}};
  const auto layer = sheet::revolved_lines(view, {0.5, 0.25});
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->strokes.size(), 2U);
  EXPECT_TRUE(layer->strokes[0].closed);
  EXPECT_EQ(layer->style.width, 0.25);
  EXPECT_EQ(layer->strokes[1].points, (std::vector<Vec2>{{15, 7}, {15, 43}}));
  EXPECT_GT(layer->strokes[1].dashes.dots, 0);
  EXPECT_FALSE(sheet::revolved_lines(drawing::ViewDrawing(), {0.5, 0.25}));
}

}  // namespace
}  // namespace epura::test::limit_lines_test
