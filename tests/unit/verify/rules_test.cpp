// SPDX-License-Identifier: Apache-2.0
// What the judge of a drawing leaves open.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes.hpp"
#include "verify/fold_rule.hpp"
#include "verify/sample.hpp"

namespace epura::test::rules_test {
namespace {

using verify::Need;

Vec3 normal_of(const world::World& world, int triangle) {
  const auto& [a, b, c] = world.triangles[triangle];
  return glm::normalize(glm::cross(world.points[b] - world.points[a], world.points[c] - world.points[a]));
}

// A bent quadrilateral, and a triangle at each of its sides. Whichever of its own triangles a fold is measured from,
// its plane is uncertain by the angle to their mean.
TEST(FoldRule, LeavesFoldsOfBentPolygonsOpen) {
  Shape shape;
  shape.points = {{0, 0, 0},     {1, 0, 0},    {1, 1, 0.5},  {0, 1, 0},
                  {0.5, -1, -1}, {2, 0.5, -1}, {0.5, 2, -1}, {-1, 0.5, -1}};
  shape.faces = {{0, 1, 2, 3}, {1, 0, 4}, {2, 1, 5}, {3, 2, 6}, {0, 3, 7}};
  const world::World world = world_of(shape);
  const auto& polygon = world.models[0].mesh->polygon;
  int folds = 0;
  for (int own = 0; own < static_cast<int>(polygon.size()); ++own)
    for (int other = 0; other < static_cast<int>(polygon.size()); ++other) {
      if (std::ranges::count(polygon, polygon[own]) != 2 || polygon[other] == polygon[own]) continue;
      std::vector<int> common;
      for (const int v : world.triangles[own])
        if (std::ranges::count(world.triangles[other], v) > 0) common.push_back(v);
      if (common.size() != 2) continue;
      ++folds;
      const double cosine = glm::dot(normal_of(world, own), normal_of(world, other));
      const double angle = std::acos(cosine) * 180 / std::numbers::pi;
      std::sort(common.begin(), common.end());
      for (const double less : {-1.0, 1.0, 60.0}) {
        edges::EdgeOptions options;
        options.crease_angle = angle - less;
        const Need need = verify::FoldRule(world, options, 0).fold({common[0], common[1]}, own, other);
        EXPECT_EQ(need, less > 30 ? Need::asked : Need::possible) << angle << " " << less;
      }
    }
  EXPECT_EQ(folds, 4);
}

// Of an edge of this length, a window two wide is seen.
double tested_length(double length) {
  projection::Projection projection = from_above();
  projection.window = projection::Window{{-1, -1}, {1, 1}};
  const Result r = draw(world_of(plate(0, -length / 2, length, length / 2, 0)), projection);
  EXPECT_EQ(r.drawn.edges.size(), 1U);
  const view::ViewLimits limits;
  const verify::VerifyInput input{r.world, r.view.projection, limits, r.drawn, r.hidden, r.drawing};
  const verify::Viewing viewing = verify::viewing_of(input);
  const auto place = verify::position_on<verify::Bounded>(input.ends_of(r.drawn.edges[0]), r.drawn.edges[0].t[0]);
  const verify::PageFrame frame(verify::sight_from(viewing, place), 0);
  return verify::population_of(input, viewing, {r.view.extent, r.view.contact.touching}, frame).lines[0].length;
}

// Parameters are doubles. On an edge of 1e12, neighbouring ones are 1e-4 apart.
TEST(Samples, LieOnEdgesWhosePlacesCanBeTold) {
  for (const double length : {10.0, 1e3, 1e6}) EXPECT_GT(tested_length(length), 0);
  EXPECT_EQ(tested_length(1e12), 0);
}

}  // namespace
}  // namespace epura::test::rules_test
