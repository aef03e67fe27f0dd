// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: centre lines and diameters of models that a transform has moved.
#include "world/placed_circles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "mesh/read.hpp"
#include "scene/transform.hpp"

namespace epura::placed_circles_test {
namespace {

world::World world_of(const std::string& transform) {
  const auto mesh = std::make_shared<const mesh::Mesh>(mesh::read_mesh(EPURA_TEST_SAMPLES "/models/bracket.obj"));
  const auto other = std::make_shared<const mesh::Mesh>(mesh::read_mesh(EPURA_TEST_SAMPLES "/models/flange.obj"));
  return world::make_world({{other, Mat4(1)}, {mesh, scene::parse_transform(transform)}});
}

TEST(PlacedCircles, AreWhereTheModelStands) {
  const Mat4 place = scene::parse_transform("scale:2 rotate:y,35 translate:300,0,-20");
  const world::World world = world_of("scale:2 rotate:y,35 translate:300,0,-20");
  const auto circles = world::find_circles(world, 1);
  ASSERT_EQ(circles.size(), 16U);
  int found = 0;
  for (const mesh::MeshCircle& circle : circles) {
    for (const int v : circle.vertices)
      EXPECT_NEAR(glm::distance(world.points[world.first_vertex[1] + v], circle.centre), circle.radius, 1e-4);
    if (std::abs(circle.radius - 2 * 13) > 1e-4) continue;
    ++found;
    const double y = circle.centre.y > 130 ? 70 : 60;
    EXPECT_LT(glm::distance(circle.centre, Vec3(place * Vec4(40, y, 48, 1))), 1e-4);
    EXPECT_NEAR(std::abs(circle.axis.y), 1, 1e-9);
  }
  EXPECT_EQ(found, 2);
}

TEST(PlacedCircles, UnequalScalesMakeEllipses) {
  // Holes along y become ellipses, slots along z, and the fillets along x stay round.
  const auto circles = world::find_circles(world_of("scale:2,1,1"), 1);
  ASSERT_EQ(circles.size(), 2U);
  for (const mesh::MeshCircle& circle : circles) EXPECT_NEAR(circle.radius, 12, 1e-4);
}

TEST(PlacedCircles, ThoseWithCentreLinesAreHalfATurnAtLeast) {
  const world::World world = world_of("scale:1");
  EXPECT_EQ(world::find_round_rims(world, 1).size(), 6U + 8);  // the fillets are quarters
  EXPECT_EQ(world::find_round_rims(world, 0).size(), 24U);
}

}  // namespace
}  // namespace epura::placed_circles_test
