// SPDX-License-Identifier: Apache-2.0
#include "sheet/projection_symbol.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::projection_symbol_test {
namespace {

struct Parts {
  double cone_small, cone_large;  // abscissae of the ends of the cone
  double circles;                 // and of the centre of the circles
};

Parts parts(const sheet::Furniture& symbol) {
  const std::vector<Vec2>& cone = symbol.medium.at(0).points;
  Parts found{0, 0, symbol.medium.at(1).curves.at(0).centre.x};
  for (std::size_t i = 0; i < cone.size(); ++i)
    (std::abs(cone[i].y) < 2 ? found.cone_small : found.cone_large) = cone[i].x;
  return found;
}

// The circles are the view of the small end, since both are seen. That is the view from the left here: in first angle
// projection it stands at the right of the cone, in third angle at its left.
TEST(ProjectionSymbol, CirclesStandWhereTheViewOfTheSmallEndStands) {
  const Parts first = parts(sheet::projection_symbol(ProjectionAngle::first, 3.5, {0, 0}));
  EXPECT_LT(first.cone_small, first.cone_large);
  EXPECT_GT(first.circles, first.cone_large);
  const Parts third = parts(sheet::projection_symbol(ProjectionAngle::third, 3.5, {0, 0}));
  EXPECT_LT(third.cone_small, third.cone_large);
  EXPECT_LT(third.circles, third.cone_small);
}

TEST(ProjectionSymbol, SizesFollowTheLettering) {
  for (const double h : {2.5, 3.5, 7.0}) {
    const sheet::Furniture symbol = sheet::projection_symbol(ProjectionAngle::first, h, {10, 20});
    const std::vector<Vec2>& cone = symbol.medium.at(0).points;
    EXPECT_NEAR(std::abs(cone[1].x - cone[2].x), 2 * h, 1e-12);
    for (const auto& [circle, radius] : {std::pair(1, h / 2), std::pair(2, h)}) {
      const sheet::Stroke& stroke = symbol.medium.at(static_cast<std::size_t>(circle));
      EXPECT_TRUE(stroke.closed);
      for (const Vec2& p : stroke.points) EXPECT_NEAR(glm::length(p - stroke.curves[0].centre), radius, 1e-12);
    }
    sheet::Rectangle box{{10, 20}, {10, 20}};
    for (const auto* strokes : {&symbol.medium, &symbol.narrow})
      for (const sheet::Stroke& stroke : *strokes)
        for (const Vec2& p : stroke.points) box = sheet::united(box, {p, p});
    EXPECT_LT(glm::length(box.size() - sheet::projection_symbol_size(h)), 1e-9);
    EXPECT_LT(glm::length(box.centre() - Vec2(10, 20)), 1e-9);
  }
}

}  // namespace
}  // namespace epura::projection_symbol_test
