// SPDX-License-Identifier: Apache-2.0
#include "edges/intersections.hpp"

#include <gtest/gtest.h>

#include "edges/crossing_candidates.hpp"
#include "shapes.hpp"

namespace epura::test {
namespace {

// An upright triangle, which crosses z = 0 from x = 0 to 0.5, and a level one that begins at x = `begin`.
std::vector<edges::FaceCrossing> crossings(double begin, double contact) {
  const Shape upright{{{0, 0, -1}, {0, 0, 1}, {1, 0, 1}}, {{0, 1, 2}}, {}};
  const Shape level{{{begin, -1, 0}, {begin, 1, 0}, {3, 0, 0}}, {{0, 1, 2}}, {}};
  const scene::World world = world_of(std::vector<Shape>{upright, level});
  return edges::find_intersections(world, 1, contact, edges::all_triangles(world)).found;
}

TEST(Intersections, AreLongerThanContact) {
  constexpr double contact = 0.01;
  const auto found = crossings(0.4, contact);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(glm::distance(found[0].ends[0], found[0].ends[1]), 0.1, 1e-12);
  EXPECT_NEAR(found[0].angle, 90, 1e-9);
  EXPECT_EQ(crossings(0.48, contact).size(), 1U);
  EXPECT_TRUE(crossings(0.495, contact).empty());
  EXPECT_TRUE(crossings(0.4999, contact).empty());
  EXPECT_EQ(crossings(0.495, 1e-6).size(), 1U);
}

}  // namespace
}  // namespace epura::test
