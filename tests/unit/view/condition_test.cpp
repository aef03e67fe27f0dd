// SPDX-License-Identifier: Apache-2.0
// Condition numbers that can be written down: shares of coordinates, centre, plane and direction.
#include "view/condition.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace epura::test::condition_test {
namespace {

constexpr double rounding = 1e-12;

Box box_around(const Vec3& middle, double half) { return {middle - Vec3(half), middle + Vec3(half)}; }

TEST(Condition, FromAboveIsThatOfCoordinatesAndSize) {
  const view::Condition here = view::condition_of(from_above(), box_around(Vec3(0), 2));
  EXPECT_NEAR(here.number, 0.5 + 1, rounding);
  EXPECT_EQ(here.moved_by_files, 0);
  const view::Condition far = view::condition_of(from_above(), box_around(Vec3(1e6, 0, 0), 2));
  EXPECT_NEAR(far.number / ((1e6 + 2) / 4 + 1), 1, rounding);
  EXPECT_EQ(far.why, "the model is small for its distance from the origin");
  EXPECT_NEAR(far.digits_lost(), std::log10(250001.5), 1e-9);
}

TEST(Condition, OfFlatProjectorsSaysSo) {
  projection::Projection p = from_above();
  p.projector = {10, 0, 1};
  const view::Condition condition = view::condition_of(p, box_around(Vec3(0), 2));
  // Along u: a tangent of 10, so that the drawing has 4 + 40; the direction counts 2 * 20 * 4 + 4.
  EXPECT_NEAR(condition.number, 22.0 / 44 + 164.0 / 44, rounding);
  EXPECT_EQ(condition.why, "projectors are nearly parallel to the plane of projection");
}

TEST(Condition, ForAWindowCountsItsPlace) {
  projection::Projection p = from_above();
  p.window = projection::Window{{999, 0}, {1001, 2}};
  const view::Condition condition = view::condition_of(p, box_around(Vec3(1000, 1, 0), 1));
  EXPECT_NEAR(condition.number, (1001.0 + 2 + 1001) / 2, 1e-9);
  EXPECT_NEAR(view::condition_of(from_above(), box_around(Vec3(1000, 1, 0), 1)).number, 1001.0 / 2 + 1, 1e-9);
}

// The viewer stands in a box of 2 x 2 x 2: depths count from an eighth.
TEST(Condition, OfAViewerInTheSceneBeginsAtASixteenthOfItsDepth) {
  const auto p = perspective({0, 0, 0.5}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0});
  const view::Condition condition = view::condition_of(p, box_around(Vec3(0), 1));
  // Places from -8 to 8: 16 wide. Coordinates, centre, distance from the plane, direction.
  EXPECT_NEAR(condition.number,
              (8 + 8 * 8) / 16.0 + (8 * 0.5 * 8) / 16.0 + (8 * 1.5 / 1.5) / 16.0 + (8 * 1.5 * 8) / 16.0, rounding);
  EXPECT_EQ(condition.why, "projectors are nearly parallel to the plane of projection");
}

TEST(Condition, OfFilesIsTheirRoundingByTheSizeOfTheDrawing) {
  const view::Condition condition = view::condition_of(from_above(), box_around(Vec3(0), 2), Vec3(0.004));
  EXPECT_NEAR(condition.moved_by_files, 0.001, rounding);
  EXPECT_NEAR(condition.digits_left(), 3, 1e-9);
}

TEST(Condition, OfAPointIsOne) { EXPECT_EQ(view::condition_of(from_above(), {Vec3(3), Vec3(3)}).number, 1); }

}  // namespace
}  // namespace epura::test::condition_test
