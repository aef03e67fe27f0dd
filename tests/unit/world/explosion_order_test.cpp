// SPDX-License-Identifier: Apache-2.0
// Bolts, nuts and rods come out of their holes in order.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "shapes.hpp"
#include "world/exploded_world.hpp"

namespace epura::test::explosion_order_test {
namespace {

/// Lowest and highest point of a body along z.
struct Reach {
  double low, high;
};

Shape ring(double inner, double outer, double low, double high) {
  return revolved({{inner, low}, {outer, low}, {outer, high}, {inner, high}, {inner, low}}, 48);
}

// Rings around the z axis, from below: a nut, a plate, a bracket; and the bolt through all of them.
std::vector<Shape> bolted() {
  return {ring(5, 40, 0, 10), ring(5, 15, 10, 16), ring(5, 8, -6, 0),
          revolved({{0, -8}, {5, -8}, {5, 16}, {9, 16}, {9, 22}, {0, 22}}, 48)};
}

std::vector<Reach> exploded(const std::vector<Shape>& shapes, double factor) {
  const world::World world = recognised(world_of(shapes));
  scene::ExplodeDescription move;
  move.factor = {factor, "--explode"};
  const std::vector<std::string> names(shapes.size(), "ring");
  const world::ExplodedWorld apart = world::explode_world(world, std::vector{move}, names);
  std::vector<Reach> reaches;
  for (std::size_t m = 0; m < shapes.size(); ++m) {
    Reach& reach = reaches.emplace_back(Reach{1e9, -1e9});
    for (int t = apart.world.first_triangle[m]; t < apart.world.first_triangle[m + 1]; ++t)
      for (const int v : apart.world.triangles[static_cast<std::size_t>(t)]) {
        const double z = apart.world.points[static_cast<std::size_t>(v)].z;
        reach = {std::min(reach.low, z), std::max(reach.high, z)};
      }
  }
  return reaches;
}

TEST(ExplosionOrder, BoltsLeaveOnTheSideOfTheirHeadsBeyondAllTheyHold) {
  for (const double factor : {0.5, 1.5, 3.0}) {
    const std::vector<Reach> z = exploded(bolted(), factor);
    const auto& [nut, plate, bracket, bolt] = std::array{z[2], z[0], z[1], z[3]};
    EXPECT_EQ(plate.low, 0) << "the largest one stays";
    EXPECT_LT(nut.high, plate.low);
    EXPECT_GT(bracket.low, plate.high);
    EXPECT_GE(bolt.low, bracket.high + 10 * factor - 1e-9) << "apart by its diameter times the factor";
  }
}

TEST(ExplosionOrder, WhichOfEqualBodiesStaysDoesNotDependOnTheirOrder) {
  const Shape low = ring(5, 40, 0, 10), high = ring(5, 40, 30, 40);
  const std::vector<Reach> one = exploded({low, high}, 1), other = exploded({high, low}, 1);
  EXPECT_EQ(one[0].low, 0);
  EXPECT_EQ(other[1].low, 0);
  EXPECT_EQ(one[1].low, other[0].low);
  EXPECT_GT(one[1].low, 30);
}

// Upside down, the bolt leaves downwards.
TEST(ExplosionOrder, SidesDependOnTheHeadAlone) {
  std::vector<Shape> turned = bolted();
  for (Shape& shape : turned) {
    for (auto& p : shape.points) p = {p[0], -p[1], -p[2]};
  }
  const std::vector<Reach> z = exploded(turned, 1.5);
  EXPECT_LT(z[3].high, z[1].low);
  EXPECT_GT(z[2].low, z[0].high);
}

// A rod with a nut on either side stays in its holes, and the nuts leave beyond its ends.
TEST(ExplosionOrder, RodsStayBetweenTheirNuts) {
  const std::vector<Reach> z = exploded(
      {ring(5, 40, 0, 10), ring(5, 8, -6, 0), ring(5, 8, 10, 16), revolved({{0, -12}, {5, -12}, {5, 22}, {0, 22}}, 48)},
      1);
  EXPECT_NEAR(z[3].low, -12, 1e-9);
  EXPECT_LT(z[1].high, z[3].low);
  EXPECT_GT(z[2].low, z[3].high);
}

}  // namespace
}  // namespace epura::test::explosion_order_test
