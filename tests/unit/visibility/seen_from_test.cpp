// SPDX-License-Identifier: Apache-2.0
#include "visibility/seen_from.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace epura::test::seen_from_test {
namespace {

constexpr double pi = std::numbers::pi;

// Points of a page with cells of one unit.
view::ProjectedScene page(const std::vector<view::GridPoint>& points) {
  view::ProjectedScene view;
  view.cell = 1;
  view.grid.resize(points.size());
  view.vertices.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    view.grid[i] = points[i];
    view.vertices[i] = {static_cast<double>(points[i].x), static_cast<double>(points[i].y), 0, 1};
  }
  return view;
}

TEST(Turns, MeetAllTheWayRound) {
  EXPECT_TRUE(visibility::turns_meet({3, 3.5}, {-3, -2.9}));
  EXPECT_TRUE(visibility::turns_meet({-3, -2.9}, {3, 3.5}));
  EXPECT_FALSE(visibility::turns_meet({3, 3.1}, {-3, -2.9}));
  EXPECT_TRUE(visibility::turns_meet(visibility::all_around, {3.1, 3.2}));
  EXPECT_TRUE(visibility::turns_meet({1, 2}, {2, 3}));
}

TEST(SeenFrom, ATriangleWithACornerThereReachesFromSideToSide) {
  const view::ProjectedScene view = page({{0, 0}, {-1000, 1}, {-1000, -1}});
  const visibility::SeenFrom hub(view, {0, 0});
  const visibility::Turn turn = hub.of_triangle(view, {{0, 1, 2}, 0});
  EXPECT_NEAR(turn[0], pi - 1e-3, 1e-6);
  EXPECT_NEAR(turn[1], pi + 1e-3, 1e-6);
}

TEST(SeenFrom, WhatLiesWithinRoundingLiesAllAround) {
  const view::ProjectedScene view = page({{3, 0}, {1000, 0}, {1000, 5}, {-50, -50}, {50, -50}, {0, 80}});
  const visibility::SeenFrom hub(view, {0, 0});
  EXPECT_EQ(hub.of_triangle(view, {{0, 1, 2}, 0}), visibility::all_around);
  EXPECT_EQ(hub.of_triangle(view, {{3, 4, 5}, 0}), visibility::all_around);
  EXPECT_EQ(hub.of_line({-100, 2}, {100, 2}), visibility::all_around);
}

// Triangles at the hub lie over an edge that begins there only in its direction, as whole numbers decide.
TEST(SeenFrom, AnEdgeMeetsTheDirectionsOfAllTrianglesOverIt) {
  std::mt19937 random(1);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const int size = 1 << (1 + random() % 29);
    const auto number = [&] { return static_cast<std::int32_t>(random() % static_cast<unsigned>(2 * size)) - size; };
    const view::GridPoint place{number() / 2, number() / 2};
    const view::ProjectedScene view = page({place, {number(), number()}, {number(), number()}, {number(), number()}});
    const view::ViewTriangle triangle{{0, 1, 2}, 0};
    if (view::cross(view.grid[0], view.grid[1], view.grid[2]) == 0 ||
        !visibility::meets_on_grid(view, {0, 3}, triangle))
      continue;
    const visibility::SeenFrom hub(view, place);
    EXPECT_TRUE(visibility::turns_meet(hub.of_triangle(view, triangle), hub.of_edge(view, {0, 3})));
    ++met;
  }
  EXPECT_GT(met, 1000);
}

}  // namespace
}  // namespace epura::test::seen_from_test
