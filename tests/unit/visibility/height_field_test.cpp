// SPDX-License-Identifier: Apache-2.0
#include "visibility/height_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "shapes.hpp"

namespace epura::test::height_field_test {
namespace {

// Squares of side 1 over 0 to `n`, as high as `height` says, without those that `hole` takes.
Shape field(
    int n, const std::function<double(int, int)>& height,
    const std::function<bool(int, int)>& hole = [](int, int) { return false; }) {
  Shape shape;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) shape.points.push_back({double(i), double(j), height(i, j)});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int at = j * (n + 1) + i;
      if (hole(i, j)) continue;
      shape.faces.push_back({at, at + 1, at + n + 2});
      shape.faces.push_back({at, at + n + 2, at + n + 1});
    }
  return shape;
}

double flat(int, int) { return 0; }
double wavy(int i, int j) { return 0.3 * std::sin(i) * std::cos(2.0 * j); }

bool certified(const std::vector<Shape>& shapes, const projection::Projection& projection) {
  const Result r = draw(world_of(shapes), projection, {.smooth = true});
  const bool one = visibility::is_height_field(r.world, r.view, r.drawn);
  EXPECT_TRUE(!one || r.hidden.spans.empty());
  return one;
}

TEST(OneSheet, IsAHeightFieldFromAbove) {
  EXPECT_TRUE(certified({field(6, flat)}, from_above()));
  EXPECT_TRUE(certified({field(6, wavy)}, from_above()));
  EXPECT_TRUE(certified({field(6, wavy)}, orthographic({0.3, -0.2, 1})));
  EXPECT_TRUE(certified({field(6, wavy)}, orthographic({0.3, -0.2, -1}))) << "from below";
  EXPECT_TRUE(certified({field(6, wavy)}, perspective({3, 3, 20}, {3, 3, 0}, {0, 0, 1}, {0, 1, 0})));
}

TEST(OneSheet, HasNoWires) {
  Shape below{{{1, 1, -2}, {5, 4, -3}}, {}, {}, {{0, 1}}};
  EXPECT_FALSE(certified({field(6, flat), below}, from_above()));
}

TEST(OneSheet, MayHaveHoles) {
  const auto hole = [](int i, int j) { return i % 3 == 1 && j % 3 == 1; };
  EXPECT_TRUE(certified({field(9, wavy, hole)}, orthographic({0.3, -0.2, 1})));
  const auto touching = [](int i, int j) { return i == j && i > 0 && i < 5; };
  EXPECT_FALSE(certified({field(6, flat, touching)}, from_above())) << "holes with a common corner";
}

TEST(OneSheet, IsNotWhatIsFoldedOnThePage) {
  EXPECT_FALSE(certified({field(6, wavy)}, orthographic({1, -1, 0.1})));
  EXPECT_FALSE(certified({field(6, flat)}, orthographic({1, 0, 0.5}, {0, 0, 1})) &&
               certified({field(6, wavy)}, orthographic({1, -1, 0})));
  EXPECT_FALSE(certified({box({0, 0, 0}, {1, 1, 1})}, orthographic({1, -1, 1})));
  EXPECT_FALSE(certified({moebius(12)}, orthographic({1, -1, 1})));
}

TEST(OneSheet, IsNotTwoOfThem) {
  // One inside the outline of the other: their borders do not meet.
  EXPECT_FALSE(certified({plate(0, 0, 4, 4, 0), plate(1, 1, 2, 2, 1)}, from_above()));
  EXPECT_FALSE(certified({plate(0, 0, 1, 1, 0), plate(2, 0, 3, 1, 0)}, from_above())) << "not worth a certificate";
}

// A ramp around an axis: from above, its border closes on itself after a full turn.
Shape ramp(double turns) {
  const int steps = 40;
  Shape shape;
  for (int i = 0; i <= steps; ++i) {
    const double a = 2 * M_PI * turns * i / steps;
    for (const double r : {1.0, 2.0}) shape.points.push_back({r * std::cos(a), r * std::sin(a), 0.02 * i});
  }
  for (int i = 0; i < steps; ++i) shape.faces.push_back({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  return shape;
}

TEST(OneSheet, EndsWhereARampReachesItsBeginning) {
  EXPECT_TRUE(certified({ramp(0.9)}, from_above()));
  EXPECT_FALSE(certified({ramp(1)}, from_above())) << "touches itself on the page";
  EXPECT_FALSE(certified({ramp(1.1)}, from_above()));
  EXPECT_FALSE(certified({ramp(2.5)}, from_above()));
}

TEST(OneSheet, IsNotClipped) {
  const world::World world = world_of(field(6, wavy));
  view::ProjectedScene view =
      view::project_scene(world, perspective({3, -4, 6}, {3, 3, 0}, {0, -1, 1}, {0, 0, 1}), {.near = {}, .far = 9.0});
  const edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  EXPECT_FALSE(view.triangle_planes.empty());
  EXPECT_FALSE(visibility::is_height_field(world, view, drawn));
}

TEST(OneSheet, HidesNothingWhateverItsShape) {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  int certain = 0;
  constexpr int fields = 400;
  for (int i = 0; i < fields; ++i) {
    SCOPED_TRACE(i);
    const double height = 2 * number(), hole = 0.3 * number();
    const double steps = random() % 2 == 0 ? 2 : 0;  // many heights are equal then
    const Shape shape = field(
        5, [&](int, int) { return steps > 0 ? std::round(steps * height * number()) / steps : height * number(); },
        [&](int, int) { return number() < hole; });
    if (shape.faces.empty()) continue;
    certain += certified({shape}, orthographic({number(), -number(), 0.5 + number()})) ? 1 : 0;
  }
  EXPECT_GT(certain, fields / 20);
  EXPECT_LT(certain, fields / 2);
}

}  // namespace
}  // namespace epura::test::height_field_test
