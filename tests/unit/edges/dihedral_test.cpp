// SPDX-License-Identifier: Apache-2.0
#include "edges/dihedral.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "shapes.hpp"

namespace epura::test::dihedral_test {
namespace {

// Two triangles at the edge (0, 1) along y; the second leaves at `degrees` from going on flatly.
Shape folded(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return {{{0, 0, 0}, {0, 1, 0}, {-1, 0.3, 0}, {std::cos(a), 0.8, std::sin(a)}}, {{0, 1, 2}, {1, 0, 3}}, {}};
}

TEST(Fold, IsTheAngleFromGoingOnFlatly) {
  for (const double degrees : {0.0, 1e-6, 1.0, 30.0, 89.0, 90.0, 135.0, 179.0, 180.0, -45.0}) {
    const world::World world = world_of(folded(degrees));
    const edges::EdgeSurroundings around{world, 0, 1};
    EXPECT_NEAR(edges::fold_angle(around, {0, 1}, 0, 1), std::abs(degrees), 1e-9) << degrees;
    EXPECT_NEAR(edges::fold_angle(around, {0, 1}, 1, 0), std::abs(degrees), 1e-9) << degrees;
  }
}

TEST(Fold, DoesNotDependOnOrientation) {
  Shape shape = folded(50);
  std::swap(shape.faces[1][0], shape.faces[1][1]);
  const world::World world = world_of(shape);
  EXPECT_NEAR(edges::fold_angle({world, 0, 1}, {0, 1}, 0, 1), 50, 1e-9);
}

TEST(Fold, OfTinyAndHugeShapesIsTheSame) {
  for (const int k : {-500, 500}) {
    const world::World world = world_of(folded(50).scaled(std::ldexp(1.0, k)));
    EXPECT_NEAR(edges::fold_angle({world, 0, std::ldexp(1.0, -k)}, {0, 1}, 0, 1), 50, 1e-9) << k;
  }
}

TEST(Fold, OfExactlyTheLimitReachesIt) {
  const std::array<Vec3, 2> upright{Vec3(0, 0, 3), Vec3(2, 0, 0)};
  EXPECT_TRUE(edges::folds_by(upright, edges::FoldLimit(90)));
  EXPECT_FALSE(edges::folds_by(upright, edges::FoldLimit(90 + 1e-9)));
  const std::array<Vec3, 2> slanted{Vec3(0, 0, 1), Vec3(1, 0, 1)};
  EXPECT_TRUE(edges::folds_by(slanted, edges::FoldLimit(45 - 1e-9)));
  EXPECT_FALSE(edges::folds_by(slanted, edges::FoldLimit(45 + 1e-9)));
}

TEST(Turn, OfASurfaceDoesNotCountItsCreases) {
  const world::World world = world_of(folded(50));
  EXPECT_NEAR(edges::turn_of_surface({world, 0, 1}, 0, 60), 50, 1e-9);
  EXPECT_EQ(edges::turn_of_surface({world, 0, 1}, 0, 40), 0);
}

TEST(Apex, BesideAPartOfAnEdgeIsFarthestFromItsLine) {
  const Shape shape{{{0, 0, 0}, {4, 0, 0}, {3, 0.5, 0}, {2, 2, 0}}, {{1, 2, 3}, {0, 1, 3}}, {}};
  const world::World world = world_of(shape);
  const edges::EdgeSurroundings around{world, 0, 1};
  EXPECT_EQ(around.apex({0, 1}, 0), 3);
  EXPECT_EQ(around.apex({0, 1}, 1), 3);
}

TEST(Height, IsOverTheLongestSide) {
  const Shape shape{{{0, 0, 0}, {4, 0, 0}, {1, 0.5, 0}}, {{0, 1, 2}}, {}};
  EXPECT_NEAR(edges::height_of({world_of(shape), 0, 1}, 0), 0.5, 1e-15);
  EXPECT_NEAR(edges::height_of({world_of(shape), 0, 0.25}, 0), 0.125, 1e-15);
}

}  // namespace
}  // namespace epura::test::dihedral_test
