// SPDX-License-Identifier: Apache-2.0
// Contours inside recognised faces, against the triangles alone.
#include "visibility/folds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "base/nearest.hpp"
#include "laboratory/lab.hpp"
#include "shapes.hpp"

namespace epura::test::folds_test {
namespace {

const projection::Projection from_left = orthographic({-1, 0, 0});

// The nearest line on paper, visible or hidden, is within a distance of a place.
bool has_ink(const Result& r, const Vec2& place, bool visible, double within) {
  for (const drawing::Segment& s : r.drawing.segments)
    if (s.visible == visible && distance_to_segment(place, s.from, s.to) <= within) return true;
  return false;
}

Vec2 on_page(const Result& r, const Vec3& point) {
  const Vec4 page = r.drawing.world_to_page * Vec4(point, 1);
  return Vec2(page) / page.w;
}

// Two strips one behind the other. The one behind is a free form of folds of 24 degrees; its middle is a wall seen
// edge-on, and what is beyond it lies deeper.
Shape strip_with_a_wall() {
  return {
      {{0, 1, 1}, {1, 0, 1}, {1, 1, 2}, {2, 0, 2}, {2, 1, 1}, {3, 0, 2}, {3, 1, 0}, {4, 0, 2}, {4, 1, 0}, {5, 0, 1}},
      {{0, 2, 1}, {1, 2, 3}, {4, 6, 5}, {5, 6, 7}, {6, 8, 7}, {7, 8, 9}},
      {}};
}

TEST(Folds, WallsOfFreeFormsAreNoFolds) {
  const world::World world = recognised(world_of(strip_with_a_wall()));
  ASSERT_NE(world.models[0].part, nullptr);
  const Result r = draw(world, from_left);
  const auto place = [&](double t) { return on_page(r, Vec3(3, 0, 2) + t * Vec3(0, 1, -2)); };
  for (const double t : {0.1, 0.2, 0.3, 0.4}) EXPECT_FALSE(has_ink(r, place(t), true, 1e-6)) << t;
  for (const double t : {0.55, 0.65, 0.75, 0.85, 0.95}) EXPECT_TRUE(has_ink(r, place(t), true, 1e-6)) << t;
  for (const double t : {0.1, 0.2, 0.3, 0.4}) EXPECT_TRUE(has_ink(r, place(t), false, 1e-6)) << t;
}

// A contour of a free form that is its outline is drawn where other faces hide it, too.
TEST(Folds, OutlinesOfFreeFormsAreDrawnWhereTheyAreHidden) {
  const Shape shape{{{4, 0, 0}, {3, 1, 1}, {0, 3, 0}, {3, 0, 4}, {3, 3, 3}, {2, 1, 0}, {0, 4, 2}, {1, 1, 0}},
                    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {4, 6, 5}, {4, 5, 7}},
                    {}};
  const Result r = draw(recognised(world_of(shape)), from_above());
  const auto place = [&](double t) { return on_page(r, Vec3(3, 1, 1) + t * Vec3(-3, 2, -1)); };
  for (const double t : {0.05, 0.15, 0.2, 0.65, 0.8, 0.95}) EXPECT_TRUE(has_ink(r, place(t), true, 1e-6)) << t;
  for (const double t : {0.3, 0.4, 0.5, 0.55}) EXPECT_TRUE(has_ink(r, place(t), false, 1e-6)) << t;
}

// A strip of triangles between two rows of lattice points, and a plate of two triangles somewhere.
Shape random_strip(std::mt19937& random) {
  const auto number = [&](int n) { return static_cast<double>(random() % static_cast<unsigned>(n)); };
  Shape shape;
  const int rungs = 4 + static_cast<int>(random() % 3);
  double z = number(4);
  for (int i = 0; i < rungs; ++i) {
    z += number(3) - 1;
    shape.points.push_back({2.0 * i, 0, z});
    shape.points.push_back({2.0 * i + number(2), 3, z + number(2)});
  }
  for (int i = 0; i + 3 < 2 * rungs; i += 2) {
    shape.faces.push_back({i, i + 1, i + 2});
    shape.faces.push_back({i + 2, i + 1, i + 3});
  }
  const auto first = static_cast<int>(shape.points.size());
  const double x = number(6), y = number(4), height = number(8);
  for (const auto& [dx, dy] : {std::array{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {0.0, 2.0}})
    shape.points.push_back({x + dx, y + dy, height});
  shape.faces.push_back({first, first + 1, first + 2});
  shape.faces.push_back({first, first + 2, first + 3});
  return shape;
}

// Whether no triangle of a world is seen at a place.
bool is_paper(const Result& r, const Vec2& place) {
  for (const auto& [a, b, c] : r.world.triangles) {
    const std::array<Vec2, 3> p{on_page(r, r.world.points[a]), on_page(r, r.world.points[b]),
                                on_page(r, r.world.points[c])};
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 3; ++i) (cross(p[(i + 1) % 3] - p[i], place - p[i]) >= 0 ? left : right) += 1;
    if (left == 3 || right == 3) return false;
  }
  return true;
}

// Lines beside which there is nothing are outlines, whatever faces are recognised, and whichever near lines are joined.
TEST(Folds, OutlinesOfRandomStripsAreDrawn) {
  const std::vector<projection::Projection> views{from_left,
                                                  from_above(),
                                                  orthographic({0, -1, 0}),
                                                  orthographic({1, 1, 1}),
                                                  orthographic({2, -1, 1}),
                                                  orthographic({-1, 0, 1})};
  constexpr double beside = 1e-4, near = 0.02;
  int recognised_parts = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const Shape shape = random_strip(random);
    const world::World world = recognised(world_of(shape));
    recognised_parts += world.models[0].part != nullptr ? 1 : 0;
    for (std::size_t v = 0; v < views.size(); ++v) {
      const Result mesh = draw(world_of(shape), views[v]);
      Result part = draw(world, views[v]);
      const drawing::NearLines joined{near * part.view.extent,
                                      [](int, int, EdgeKind, bool visible) { return visible ? 2 : 1; }};
      part.drawing = drawing::make_drawing({part.world, part.view, part.drawn, part.hidden}, {1, Vec2(0)},
                                           {"joined", true, true, joined});
      const double reach = joined.reach_in_all() + part.drawing.distances.contours_moved;
      for (const drawing::Segment& s : mesh.drawing.segments) {
        const double length = glm::distance(s.from, s.to);
        if (!s.visible || !(length > 8 * reach)) continue;
        const Vec2 across = beside * mesh.view.extent / length * Vec2(s.from.y - s.to.y, s.to.x - s.from.x);
        for (const double t : {0.15, 0.35, 0.5, 0.65, 0.85}) {
          const Vec2 at = s.from + t * (s.to - s.from);
          if (!is_paper(mesh, at + across) && !is_paper(mesh, at - across)) continue;
          EXPECT_TRUE(has_ink(part, at, true, reach)) << "seed " << seed << " view " << v << " at " << at.x << ","
                                                      << at.y << " of " << s.edge[0] << "-" << s.edge[1];
        }
      }
    }
  }
  EXPECT_GT(recognised_parts, 20);
}

// The regular prism of so many sides, open above, in storeys; turned by an angle.
Shape storeys(int sides, double turned, const std::vector<double>& heights) {
  Shape shape;
  for (const double z : heights)
    for (int i = 0; i < sides; ++i) {
      const double u = turned + 2 * 3.14159265358979 * i / sides;
      shape.points.push_back({30 * std::cos(u), 30 * std::sin(u), z});
    }
  const int floors = static_cast<int>(heights.size());
  for (int floor = 0; floor + 1 < floors; ++floor)
    for (int i = 0; i < sides; ++i) {
      const int a = floor * sides + i, b = floor * sides + (i + 1) % sides;
      shape.faces.push_back({a, b, b + sides, a + sides});
    }
  std::vector<int> ground;
  for (int i = sides; i-- > 0;) ground.push_back(i);
  shape.faces.push_back(ground);
  return shape;
}

// Of walls parallel to the projectors, nothing hides their foot once a depth limit has cut their top off.
TEST(DepthLimits, CutWallsEdgeOnHideNothing) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const auto uniform = [&](double min, double max) { return min + (max - min) * (double(random()) / 4294967296.0); };
    const int sides = 3 + static_cast<int>(random() % 9);
    const Shape shape = storeys(sides, uniform(0, 1), {0, 50, 100});
    const view::ViewLimits limits{.near = -uniform(1, 99)};
    const double perimeter = sides * 60 * std::sin(3.14159265358979 / sides);
    for (const bool recognises : {false, true}) {
      const world::World world = recognises ? recognised(world_of(shape)) : world_of(shape);
      const Result r = draw(world, from_above(), {}, limits);
      EXPECT_NEAR(r.visible(), perimeter, 1e-4) << sides << " sides, near " << *limits.near;
    }
  }
}

}  // namespace
}  // namespace epura::test::folds_test
