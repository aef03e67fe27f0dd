// SPDX-License-Identifier: Apache-2.0
#include "edges/crossing_candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "edges/convex_bodies.hpp"
#include "edges/intersections.hpp"
#include "shapes.hpp"

namespace epura::test::crossing_candidates_test {
namespace {

constexpr double contact = 0x1p-29;

std::size_t candidates(const std::vector<Shape>& shapes) {
  return edges::crossing_candidates(world_of(shapes), 0x1p-3, contact).triangles.size();
}

// Around the z axis, from -1 to 1, with fans for its ends.
Shape prism(int sides) {
  Shape shape;
  std::vector<int> top, bottom;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * M_PI * i / sides;
    for (const double z : {-1.0, 1.0}) shape.points.push_back({std::cos(a), std::sin(a), z});
    shape.faces.push_back({2 * i, (2 * i + 2) % (2 * sides), (2 * i + 3) % (2 * sides), 2 * i + 1});
    top.push_back(2 * i + 1);
    bottom.insert(bottom.begin(), 2 * i);
  }
  shape.faces.push_back(top);
  shape.faces.push_back(bottom);
  return shape;
}

// A double pyramid whose base runs `turns` times around the axis.
Shape double_pyramid(int sides, int turns) {
  Shape shape;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * M_PI * turns * i / sides;
    shape.points.push_back({std::cos(a), std::sin(a), 0});
    shape.faces.push_back({i, (i + 1) % sides, sides});
    shape.faces.push_back({(i + 1) % sides, i, sides + 1});
  }
  shape.points.push_back({0, 0, 1});
  shape.points.push_back({0, 0, -1});
  return shape;
}

// A cube whose upper side has a corner in the middle, `depth` below it.
Shape dented(double depth) {
  Shape cube = box({0, 0, 0}, {1, 1, 1});
  Shape shape{cube.points, {}, {}};
  shape.points.push_back({0.5, 0.5, 1 - depth});
  for (const auto& face : cube.faces) {
    bool upper = true;
    for (const int v : face) upper = upper && cube.points[v][2] == 1;
    if (!upper) shape.faces.push_back(face);
    for (std::size_t i = 0; upper && i < 4; ++i) shape.faces.push_back({face[i], face[(i + 1) % 4], 8});
  }
  return shape;
}

TEST(Candidates, ConvexBodiesThatStandAloneAreNone) {
  EXPECT_EQ(candidates({box({0, 0, 0}, {1, 1, 1})}), 0U);
  EXPECT_EQ(candidates({triangulated_cube(), triangulated_cube(true).moved(1.5, 0, 0)}), 0U);
  EXPECT_EQ(candidates({prism(3)}), 0U);
  EXPECT_EQ(candidates({prism(200)}), 0U);
  EXPECT_EQ(candidates({double_pyramid(7, 1)}), 0U);
  EXPECT_EQ(candidates({box({0, 0, 0}, {1, 1, 1}), prism(12).moved(3, 0, 0), prism(64).moved(0, 4, 0)}), 0U);
}

TEST(Candidates, AreBodiesWhoseBoxesMeet) {
  EXPECT_EQ(candidates({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}), 24U);  // they touch
  EXPECT_EQ(candidates({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2}), box({3, 0, 0}, {4, 1, 1})}), 24U);
  EXPECT_EQ(candidates({box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2})}), 24U);  // one inside the other
  EXPECT_EQ(candidates({triangulated_cube(), triangulated_cube(true)}), 24U);          // in one place
}

TEST(Candidates, AreBodiesThatAreNotConvex) {
  EXPECT_EQ(candidates({dented(0.25)}), 14U);
  EXPECT_EQ(candidates({dented(1e-6)}), 14U);
  EXPECT_EQ(candidates({dented(1e-13)}), 0U) << "less than contact";
  EXPECT_EQ(candidates({dented(-0.25)}), 0U) << "a roof";
  EXPECT_EQ(candidates({dented(0.25), box({3, 0, 0}, {4, 1, 1})}), 14U);
}

TEST(Candidates, AreBodiesThatAreNotClosed) {
  Shape open = box({0, 0, 0}, {1, 1, 1});
  open.faces.pop_back();
  EXPECT_EQ(candidates({open}), 10U);
  EXPECT_EQ(candidates({plate(0, 0, 1, 1, 0)}), 2U);
}

TEST(Candidates, AreBodiesThatAreInsideOutOrTwisted) {
  Shape inside_out = box({0, 0, 0}, {1, 1, 1});
  for (auto& face : inside_out.faces) std::reverse(face.begin(), face.end());
  EXPECT_EQ(candidates({inside_out}), 12U);
  Shape twisted = box({0, 0, 0}, {1, 1, 1});
  std::reverse(twisted.faces[2].begin(), twisted.faces[2].end());
  EXPECT_EQ(candidates({twisted}), 12U);
}

TEST(Candidates, AreBodiesThatRunTwiceAroundTheirMiddle) {
  // Every edge of it is folded outwards, and yet its faces cross.
  const world::World world = world_of(double_pyramid(5, 2));
  EXPECT_EQ(edges::crossing_candidates(world, 1, contact).triangles.size(), 10U);
  EXPECT_FALSE(edges::find_intersections(world, 1, contact, edges::all_triangles(world)).found.empty());
}

TEST(Candidates, AreNotTrianglesTooLowForAPlane) {
  // Needles side by side in one line: the boxes of all of them meet.
  constexpr int needles = 100;
  Shape fan{{{0, 0, 0}, {0, 1, 1}, {1, 0, 1}}, {{0, 1, 2}}, {}};
  for (int i = 0; i <= needles; ++i) fan.points.push_back({1 + 1.0 * i / needles, 2 + 2.0 * i / needles, 0});
  for (int i = 0; i < needles; ++i) fan.faces.push_back({0, i + 3, i + 4});
  const world::World world = world_of(fan);
  EXPECT_EQ(edges::crossing_candidates(world, 0x1p-3, contact).triangles, std::vector<int>{0});
  EXPECT_TRUE(edges::find_intersections(world, 0x1p-3, contact, edges::all_triangles(world)).found.empty());
}

TEST(Candidates, WithoutContactNothingIsCertain) {
  EXPECT_EQ(edges::crossing_candidates(world_of(box({0, 0, 0}, {1, 1, 1})), 1, 0).triangles.size(), 12U);
}

TEST(Candidates, ConvexBodiesLieBehindTheirPlanes) {
  for (const int sides : {3, 5, 17, 64, 1000}) {
    const world::World world = world_of(prism(sides));
    const UnsetVector<Vec3> points = edges::normalised_points(world, 0.5);
    const edges::BodyTable bodies = edges::bodies_of(world, points);
    std::vector<char> convex(bodies.box.size(), 1);
    edges::keep_convex(world, points, bodies, contact, convex);
    ASSERT_EQ(convex, std::vector<char>{1}) << sides;
    for (const auto& [a, b, c] : world.triangles) {
      const Vec3 normal = glm::normalize(glm::cross(points[b] - points[a], points[c] - points[a]));
      for (const Vec3& p : points) ASSERT_LE(glm::dot(normal, p - points[a]), contact) << sides;
    }
  }
}

}  // namespace
}  // namespace epura::test::crossing_candidates_test
