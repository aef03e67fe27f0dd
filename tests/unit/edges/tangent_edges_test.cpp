// SPDX-License-Identifier: Apache-2.0
#include "edges/tangent_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "edges/feature_edges.hpp"
#include "shapes.hpp"

namespace epura::test::tangent_edges_test {
namespace {

constexpr double pi = std::numbers::pi;

// The tangent edges of the only model, as pairs of vertices.
std::set<std::pair<int, int>> tangents(const world::World& world) {
  const edges::EdgeOptions options{.contour = false, .boundary = false, .crease = false, .tangent = true};
  const view::ProjectedScene view = view::project_scene(world, orthographic({1.1, -2, 1.3}), {});
  const auto kinds = edges::feature_edges(world, view, 0, options);
  std::set<std::pair<int, int>> found;
  for (std::size_t e = 0; e < kinds.size(); ++e)
    if (kinds[e]) {
      EXPECT_EQ(*kinds[e], EdgeKind::tangent);
      const auto& v = world.models[0].mesh->edges[e].vertex;
      found.emplace(v[0], v[1]);
    }
  return found;
}

// A strip between y = 0 and 10 over a line in the plane x, z; vertex i at y = 0 and i + n at y = 10.
Shape strip(const std::vector<Vec2>& line, bool triangles = false) {
  Shape shape;
  const int n = static_cast<int>(line.size());
  for (const double y : {0.0, 10.0})
    for (const Vec2& p : line) shape.points.push_back({p.x, y, p.y});
  for (int i = 0; i + 1 < n; ++i) {
    if (triangles) {
      shape.faces.push_back({i, i + 1, n + i + 1});
      shape.faces.push_back({i, n + i + 1, n + i});
    } else {
      shape.faces.push_back({i, i + 1, n + i + 1, n + i});
    }
  }
  return shape;
}

// A flat, a fillet of a quarter turn in `steps`, another flat.
std::vector<Vec2> angle_iron(int steps, double flat_length) {
  std::vector<Vec2> line{{-flat_length, 0}};
  for (int i = 0; i <= steps; ++i) {
    const double a = pi / 2 * i / steps;
    line.emplace_back(5 * std::sin(a), 5 - 5 * std::cos(a));
  }
  line.emplace_back(5, 5 + flat_length);
  return line;
}

TEST(TangentEdges, StandWhereAFilletBegins) {
  for (const bool triangles : {false, true})
    for (const int steps : {4, 8, 24, 90}) {
      const int n = steps + 3;
      EXPECT_EQ(tangents(world_of(strip(angle_iron(steps, 20), triangles))),
                (std::set<std::pair<int, int>>{{1, n + 1}, {steps + 1, n + steps + 1}}))
          << steps;
    }
}

TEST(TangentEdges, AreNotTheFacetsOfOneSurface) {
  std::vector<Vec2> circle;
  for (int i = 0; i <= 48; ++i) circle.emplace_back(std::cos(2 * pi * i / 48), std::sin(2 * pi * i / 48));
  EXPECT_EQ(tangents(world_of(strip(circle))), (std::set<std::pair<int, int>>{}));
  EXPECT_EQ(tangents(world_of(strip(circle, true))), (std::set<std::pair<int, int>>{}));
  EXPECT_EQ(tangents(world_of(triangulated_cube())), (std::set<std::pair<int, int>>{}));
}

// Rings of points at heights and radii, closed to a skin without ends.
Shape turned(const std::vector<Vec2>& profile, int sectors) {
  Shape shape;
  const int n = static_cast<int>(profile.size());
  for (int s = 0; s < sectors; ++s)
    for (const Vec2& p : profile) {
      const double a = 2 * pi * s / sectors;
      shape.points.push_back({p.x * std::cos(a), p.x * std::sin(a), p.y});
    }
  for (int s = 0; s < sectors; ++s)
    for (int i = 0; i + 1 < n; ++i) {
      const int here = s * n + i, next = (s + 1) % sectors * n + i;
      shape.faces.push_back({here, next, next + 1, here + 1});
    }
  return shape;
}

TEST(TangentEdges, RunRoundWhereAShaftBecomesRound) {
  std::vector<Vec2> profile{{10, -40}};
  for (int i = 0; i < 12; ++i) profile.emplace_back(10 * std::cos(pi / 2 * i / 12), 10 * std::sin(pi / 2 * i / 12));
  const int n = static_cast<int>(profile.size());
  const auto found = tangents(world_of(turned(profile, 36)));
  EXPECT_EQ(found.size(), 36U);
  for (const auto& [a, b] : found) {
    EXPECT_EQ(a % n, 1);
    EXPECT_EQ(b % n, 1);
  }
}

TEST(TangentEdges, OfASphereAreNone) {
  std::vector<Vec2> profile;
  for (int i = 1; i < 24; ++i) profile.emplace_back(std::sin(pi * i / 24), -std::cos(pi * i / 24));
  EXPECT_EQ(tangents(world_of(turned(profile, 48))).size(), 0U);
}

}  // namespace
}  // namespace epura::test::tangent_edges_test
