// SPDX-License-Identifier: Apache-2.0
// Projections at their extremes: the cases of the stability study, more tightly than it judges, and what has no length.
#include <gtest/gtest.h>

#include <cmath>

#include "measured.hpp"
#include "shapes.hpp"
#include "study/stability/case.hpp"

namespace epura::test::projection_extremes_test {
namespace {

TEST(ProjectionExtremes, AreDrawnRight) {
  for (const auto& cases : {stability::projection_cases(), stability::viewer_cases()})
    for (const stability::Case& one : cases)
      for (const double step : one.steps) {
        SCOPED_TRACE(one.id + " at " + std::to_string(step));
        // A far eye is near to the parallel drawing, by the tolerance of its case.
        expect_right(one.measure(stability::Lab(), step), one.id == "P16" ? 1 : 0.01);
      }
}

TEST(ProjectionExtremes, PowersOfTwoScaleTheDrawingExactly) {
  const Result plain = draw(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic({1, 1, 1}));
  for (const int k : {-1000, -60, 60, 1000}) {
    const Result scaled = draw(world_of(box({0, 0, 0}, {1, 1, 1}).scaled(std::ldexp(1.0, k))), orthographic({1, 1, 1}));
    ASSERT_EQ(scaled.drawing.segments.size(), plain.drawing.segments.size()) << k;
    for (std::size_t i = 0; i < plain.drawing.segments.size(); ++i) {
      EXPECT_EQ(scaled.drawing.segments[i].from, plain.drawing.segments[i].from) << k;
      EXPECT_EQ(scaled.drawing.segments[i].to, plain.drawing.segments[i].to) << k;
      EXPECT_EQ(scaled.drawing.segments[i].visible, plain.drawing.segments[i].visible) << k;
    }
  }
}

TEST(ProjectionExtremes, EyeOnAVertexOrInAFace) {
  for (const Vec3& eye : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.25, 0.25, 0.25)}) {
    const world::World world = world_of({box({0, 0, 0}, {1, 1, 1}), box({-1, 3, -1}, {2, 4, 2})});
    const Result result = draw(world, perspective(eye, eye + Vec3(0, 1, 0), {0, -1, 0}, {0, 0, 1}));
    for (const drawing::Segment& s : result.drawing.segments) {
      EXPECT_TRUE(std::isfinite(s.from.x) && std::isfinite(s.from.y));
      EXPECT_TRUE(std::isfinite(s.to.x) && std::isfinite(s.to.y));
    }
  }
}

}  // namespace
}  // namespace epura::test::projection_extremes_test
