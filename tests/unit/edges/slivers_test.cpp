// SPDX-License-Identifier: Apache-2.0
#include "edges/slivers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "edges/feature_edges.hpp"
#include "shapes.hpp"

namespace epura::test::slivers_test {
namespace {

// Two halves of a roof with a ridge along y, and between them, in the ridge, a sliver 0, 1, 4.
Shape roof_with_a_sliver() {
  return {
      {{0, 0, 0}, {0, 2, 0}, {-1, 1, -1}, {1, 1, -1}, {1e-9, 1, 0}}, {{0, 1, 2}, {0, 4, 1}, {4, 0, 3}, {1, 4, 3}}, {}};
}

TEST(Slivers, AreCrossedToTheFaceBehind) {
  const world::World world = world_of(roof_with_a_sliver());
  const edges::Slivers slivers({world, 0, 1}, {0, 1, 0, 0});
  EXPECT_EQ(slivers.across({0, 1}, 0).triangle, 0) << "no sliver, nothing to cross";
  EXPECT_TRUE(slivers.across({0, 1}, 1).covered) << "its longest side is drawn by the two others";
  // Entered by a shorter side, the sliver is left through the longest one.
  std::vector<int> passed;
  const edges::Beyond behind = slivers.across({0, 4}, 1, &passed);
  ASSERT_TRUE(behind.triangle);
  EXPECT_EQ(*behind.triangle, 0);
  EXPECT_FALSE(behind.covered);
  EXPECT_EQ(passed, std::vector<int>{1});
}

TEST(Slivers, AtTheBorderHaveNothingBehindThem) {
  Shape shape = roof_with_a_sliver();
  shape.faces.erase(shape.faces.begin());
  const world::World world = world_of(shape);
  const edges::Beyond behind = edges::Slivers({world, 0, 1}, {1, 0, 0}).across({0, 4}, 0);
  EXPECT_FALSE(behind.triangle);
  EXPECT_FALSE(behind.covered);
}

// A ridge along y of `needles` needles between two halves of a roof, all of one length.
Shape roof_with_needles(int needles, double width) {
  Shape roof{{{-1, 1, -1}, {1, 1, -1}}, {}, {}};
  for (int i = 0; i <= needles; ++i) roof.points.push_back({width * i / needles, i % 2 == 0 ? 0.0 : 2.0, 0});
  // The two halves.
  roof.faces.push_back({2, 3, 0});
  roof.faces.push_back({needles + 1, needles + 2, 1});
  for (int i = 0; i + 2 <= needles; ++i) roof.faces.push_back({i + 2, i + 3, i + 4});
  return roof;
}

TEST(Slivers, OfARowOfNeedlesOneSideIsDrawn) {
  for (const int needles : {2, 3, 6}) {
    const world::World world = world_of(roof_with_needles(needles, 1e-13));
    const view::ProjectedScene view = view::project_scene(world, from_above(), {});
    int creases = 0;
    for (const auto& kind : edges::feature_edges(world, view, 0, {.contour = false, .boundary = false}))
      creases += kind ? 1 : 0;
    EXPECT_EQ(creases, 1) << needles;
  }
}

// Whichever of its vertices come first in the file.
TEST(Slivers, OfTwoNeedlesOneSideIsDrawnHoweverTheyAreNumbered) {
  std::vector<int> order{2, 3, 4, 5};
  do {
    Shape roof = roof_with_needles(3, 1e-13), numbered = roof;
    for (std::size_t i = 0; i < order.size(); ++i) numbered.points[std::size_t(order[i])] = roof.points[i + 2];
    for (auto& face : numbered.faces)
      for (int& v : face)
        if (v >= 2) v = order[std::size_t(v) - 2];
    const world::World world = world_of(numbered);
    const view::ProjectedScene view = view::project_scene(world, from_above(), {});
    int creases = 0;
    for (const auto& kind : edges::feature_edges(world, view, 0, {.contour = false, .boundary = false}))
      creases += kind ? 1 : 0;
    EXPECT_EQ(creases, 1) << testing::PrintToString(order);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Slivers, AreTrianglesLowerThanThePageGridUnlessSeenEdgeOn) {
  const Shape box_and_needle = [] {
    Shape shape = box({0, 0, 0}, {1, 1, 1});
    shape.add({{{0, 0, 2}, {1, 0, 2}, {1, 1e-9, 2}}, {{0, 1, 2}}, {}});
    return shape;
  }();
  const world::World world = world_of(box_and_needle);
  const view::ProjectedScene view = view::project_scene(world, from_above(), {});
  const edges::Slivers slivers({world, 0, view.map.normalisation}, view);
  for (int t = 0; t < 12; ++t) EXPECT_FALSE(slivers.contain(t)) << t;
  EXPECT_TRUE(slivers.contain(12));
  const edges::EdgeSurroundings around{world, 0, view.map.normalisation};
  const edges::Slivers when_asked(around, edges::SliverRule(around, view));
  for (int t = 0; t <= 12; ++t) EXPECT_EQ(when_asked.contain(t), slivers.contain(t)) << t;
}

// Every quadrilateral as two triangles.
Shape triangulated(Shape shape) {
  std::vector<std::vector<int>> triangles;
  for (const auto& f : shape.faces) {
    triangles.push_back({f[0], f[1], f[2]});
    triangles.push_back({f[0], f[2], f[3]});
  }
  shape.faces = triangles;
  return shape;
}

std::vector<std::array<double, 2>> profile_of(const std::string& name, double pole) {
  std::vector<std::array<double, 2>> profile;
  const auto round = [&](int steps, double middle, double radius) {
    for (int i = 0; i <= steps; ++i) {
      const double a = M_PI * i / steps - M_PI / 2;
      profile.push_back({i == 0 || i == steps ? pole : middle + radius * std::cos(a), radius * std::sin(a)});
    }
  };
  if (name == "cone") profile = {{1, 0}, {pole, 2}};
  if (name == "spindle") profile = {{pole, -1}, {0.5, 0}, {pole, 1}};
  if (name == "sphere") round(12, 0, 1);
  // A torus whose tube touches the axis.
  if (name == "torus")
    for (int i = 0; i <= 16; ++i) {
      const double a = 2 * M_PI * i / 16;
      const bool at_pole = i == 0 || i == 16;
      profile.push_back({at_pole ? pole : 0.5 - 0.5 * std::cos(a), at_pole ? 0 : 0.5 * std::sin(a)});
    }
  return profile;
}

world::World world_in(const Shape& shape, bool single_precision) {
  mesh::Soup soup;
  soup.points = shape.points;
  soup.single_precision = single_precision;
  if (single_precision)
    for (auto& p : soup.points)
      for (double& c : p) c = static_cast<float>(c);
  for (const auto& face : shape.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_face();
  }
  return world::make_world(
      {{std::make_shared<const mesh::Mesh>(mesh::build_mesh(std::move(soup), "shape")), Mat4(1.0)}});
}

// Two halves of a square whose common border has a step of a needle, which both folds of 45 degrees make.
TEST(Slivers, BetweenTwoOppositeCreasesAreNoStep) {
  const double step = 0x1p-23;
  const Shape square{{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {step, 0, step}},
                     {{0, 1, 2}, {0, 4, 1}, {0, 3, 4}, {4, 3, 1}},
                     {}};
  const world::World world = world_in(square, true);
  const view::ProjectedScene view = view::project_scene(world, orthographic({1, -2, 3}), {});
  for (const auto& kind : edges::feature_edges(world, view, 0, {.boundary = false})) EXPECT_FALSE(kind);
}

// A block with a low step, whose wall is a slender rectangle seen edge-on from above.
Shape block_with_a_step(double height) {
  const std::vector<std::array<double, 2>> profile{{0, 0},   {160, 0}, {160, 40 + height}, {80, 40 + height},
                                                   {80, 40}, {0, 40}};
  const int n = static_cast<int>(profile.size());
  Shape block;
  for (const double y : {0.0, 96.0})
    for (const auto& [x, z] : profile) block.points.push_back({x, y, z});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    block.faces.push_back({i, j, n + j, n + i});
  }
  return block;
}

TEST(Slivers, AreNotTheWallsOfALowStep) {
  for (const double height : {1.0, 0.05, 0.01, 0.001})
    for (const bool single : {false, true}) {
      const Result drawn = draw(world_in(triangulated(block_with_a_step(height)), single), from_above());
      EXPECT_NEAR(drawn.visible(), 2 * (160 + 96) + 96, 0.01) << height << " " << single;
    }
}

struct PoleCase {
  std::string shape;
  bool triangles, single_precision;
};

class Poles : public testing::TestWithParam<PoleCase> {};

TEST_P(Poles, OfAnyRadiusAreDrawnAlike) {
  const auto [name, triangles, single_precision] = GetParam();
  const projection::Projection views[] = {orthographic({0, -1, 0}),
                                          from_above(),
                                          orthographic({1, -1, 1}),
                                          orthographic({1, 0.3, 0.2}),
                                          perspective({1, -4, 2}, {0, 0, 0}, {1, -4, 2}, {0, 0, 1}),
                                          perspective({2, -4, 3}, {0, 0, 0}, {1, -2, 0}, {0, 0, 1})};
  const auto drawn = [&, triangles = triangles, name = name, single = single_precision](
                         double pole, const projection::Projection& view) {
    const Shape shape = revolved(profile_of(name, pole), 24);
    return draw(world_in(triangles ? triangulated(shape) : shape, single), view);
  };
  for (const projection::Projection& view : views) {
    const Result pointed = drawn(0, view);
    const double ink = pointed.visible() + pointed.hidden_length();
    for (int exponent = 2; exponent <= 18; ++exponent) {
      const double pole = std::pow(10, -exponent);
      const Result blunt = drawn(pole, view);
      // Both rings of a pole and what they take away from the rest.
      const double allowed = 1e-3 * ink + 8 * M_PI * pole;
      EXPECT_NEAR(blunt.visible(), pointed.visible(), allowed) << exponent;
      EXPECT_NEAR(blunt.hidden_length(), pointed.hidden_length(), allowed) << exponent;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Slivers, Poles, testing::ValuesIn([] {
                           std::vector<PoleCase> cases;
                           for (const char* shape : {"cone", "spindle", "sphere", "torus"})
                             for (const bool triangles : {false, true})
                               for (const bool single : {false, true}) cases.push_back({shape, triangles, single});
                           return cases;
                         }()),
                         [](const auto& tested) {
                           return tested.param.shape + (tested.param.triangles ? "Triangles" : "Polygons") +
                                  (tested.param.single_precision ? "Float" : "Double");
                         });

}  // namespace
}  // namespace epura::test::slivers_test
