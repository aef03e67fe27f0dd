// SPDX-License-Identifier: Apache-2.0
#include "svg/flatten.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/nearest.hpp"

namespace epura::test::flatten_test {
namespace {

Vec2 at(const svg::CubicCurve& curve, double t) {
  const double s = 1 - t;
  return s * s * s * curve.from + 3 * s * s * t * curve.a + 3 * s * t * t * curve.b + t * t * t * curve.to;
}

TEST(Flatten, ChordsStayWithinATenthOfAMicrometreOfCurves) {
  for (const svg::CubicCurve& curve :
       {svg::CubicCurve{{0, 0}, {0, 50}, {50, 100}, {100, 100}}, svg::CubicCurve{{0, 0}, {90, 0}, {-40, 30}, {60, 80}},
        svg::CubicCurve{{3, 4}, {3.01, 4}, {3.02, 4.01}, {3.03, 4}}}) {
    svg::PieceRoom room(0, "test.svg");
    std::vector<Vec2> points{curve.from};
    svg::append_cubic(points, curve, room);
    double farthest = 0;
    for (int i = 0; i <= 5000; ++i) {
      double nearest = HUGE_VAL;
      for (std::size_t k = 1; k < points.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(at(curve, i / 5000.0), points[k - 1], points[k]));
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LT(farthest, 1e-4);
    EXPECT_EQ(points.back(), curve.to);
  }
}

}  // namespace
}  // namespace epura::test::flatten_test
