#include "edges/dihedral.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shapes.hpp"

namespace epura::test {
namespace {

// Two triangles at the edge (0, 1) along y; the second leaves at `degrees` from going on flatly.
Shape folded(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return {{{0, 0, 0}, {0, 1, 0}, {-1, 0.3, 0}, {std::cos(a), 0.8, std::sin(a)}}, {{0, 1, 2}, {1, 0, 3}}, {}};
}

TEST(Fold, IsTheAngleFromGoingOnFlatly) {
  for (const double degrees : {0.0, 1e-6, 1.0, 30.0, 89.0, 90.0, 135.0, 179.0, 180.0, -45.0}) {
    const World world = world_of(folded(degrees));
    const EdgeSurroundings around{world, 0, 1, 0};
    EXPECT_NEAR(fold_angle(around, {0, 1}, 0, 1), std::abs(degrees), 1e-9) << degrees;
    EXPECT_NEAR(fold_angle(around, {0, 1}, 1, 0), std::abs(degrees), 1e-9) << degrees;
  }
}

TEST(Fold, DoesNotDependOnOrientation) {
  Shape shape = folded(50);
  std::swap(shape.faces[1][0], shape.faces[1][1]);
  const World world = world_of(shape);
  EXPECT_NEAR(fold_angle({world, 0, 1, 0}, {0, 1}, 0, 1), 50, 1e-9);
}

TEST(Fold, OfTinyAndHugeShapesIsTheSame) {
  for (const int k : {-500, 500}) {
    const World world = world_of(folded(50).scaled(std::ldexp(1.0, k)));
    EXPECT_NEAR(fold_angle({world, 0, std::ldexp(1.0, -k), 0}, {0, 1}, 0, 1), 50, 1e-9) << k;
  }
}

TEST(Height, IsOverTheLongestSide) {
  const Shape shape{{{0, 0, 0}, {4, 0, 0}, {1, 0.5, 0}}, {{0, 1, 2}}, {}};
  EXPECT_NEAR(height_of({world_of(shape), 0, 1, 0}, 0), 0.5, 1e-15);
  EXPECT_NEAR(height_of({world_of(shape), 0, 0.25, 0}, 0), 0.125, 1e-15);
}

// Two halves of a roof with a ridge along y, and between them, in the ridge, a sliver 0, 1, 4.
Shape roof_with_a_sliver() {
  return {
      {{0, 0, 0}, {0, 2, 0}, {-1, 1, -1}, {1, 1, -1}, {1e-9, 1, 0}}, {{0, 1, 2}, {0, 4, 1}, {4, 0, 3}, {1, 4, 3}}, {}};
}

TEST(Slivers, AreCrossedToTheFaceBehind) {
  const World world = world_of(roof_with_a_sliver());
  const EdgeSurroundings around{world, 0, 1, 1e-6};
  const Beyond left = across_slivers(around, {0, 1}, 0);
  EXPECT_EQ(left.triangle, 0) << "no sliver, nothing to cross";
  EXPECT_TRUE(across_slivers(around, {0, 1}, 1).covered) << "its longest side is drawn by the two others";
  // Entered by a shorter side, the sliver is left through the longest one.
  const Beyond behind = across_slivers(around, {0, 4}, 1);
  ASSERT_TRUE(behind.triangle);
  EXPECT_EQ(*behind.triangle, 0);
  EXPECT_FALSE(behind.covered);
}

TEST(Slivers, AtTheBorderHaveNothingBehindThem) {
  Shape shape = roof_with_a_sliver();
  shape.faces.erase(shape.faces.begin());
  const World world = world_of(shape);
  const Beyond behind = across_slivers({world, 0, 1, 1e-6}, {0, 4}, 0);
  EXPECT_FALSE(behind.triangle);
  EXPECT_FALSE(behind.covered);
}

}  // namespace
}  // namespace epura::test
