// SPDX-License-Identifier: Apache-2.0
#include "search/line_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace epura::test::line_cells_test {
namespace {

double uniform(std::mt19937& random, double min, double max) {
  return min + (max - min) * (static_cast<double>(random()) / 4294967296.0);
}

TEST(CellGrid, WhatLiesOutsideBelongsToTheNearestCell) {
  const search::CellGrid grid{{-2, 7}, {0.5, 0.25}, 6, 4};
  EXPECT_EQ(grid.column(-1e300), 0);
  EXPECT_EQ(grid.column(-1.4), 1);
  EXPECT_EQ(grid.column(1e300), 5);
  EXPECT_EQ(grid.row(6), 0);
  EXPECT_EQ(grid.row(7.6), 2);
  EXPECT_EQ(grid.row(HUGE_VAL), 3);
}

TEST(LineCells, EveryPlaceOfTheLineIsVisitedWithItsParameter) {
  std::mt19937 random(2);
  const search::CellGrid grid{{-1, -2}, {0.5, 0.75}, 9, 5};
  for (int round = 0; round < 2000; ++round) {
    // Upright, level, along the borders of cells, into corners, out of the grid.
    const auto coordinate = [&] {
      return round % 2 == 0 ? uniform(random, -3, 5) : -3 + 0.25 * static_cast<double>(random() % 32);
    };
    const Vec2 a{coordinate(), coordinate()};
    const Vec2 b = round % 5 == 0   ? Vec2(a.x, coordinate())
                   : round % 5 == 1 ? Vec2(coordinate(), a.y)
                                    : Vec2(coordinate(), coordinate());
    std::map<int, std::array<double, 2>> visited;
    search::visit_cells(grid, a, b, 1e-9, [&](int cell, double from, double to) {
      ASSERT_TRUE(visited.emplace(cell, std::array{from, to}).second) << "twice";
      ASSERT_LE(from, to);
      ASSERT_GE(from, 0);
      ASSERT_LE(to, 1);
    });
    for (int i = 0; i <= 200; ++i) {
      const double t = i / 200.0;
      const Vec2 p = a + t * (b - a);
      const auto found = visited.find(grid.cell(grid.column(p.x), grid.row(p.y)));
      ASSERT_NE(found, visited.end()) << a.x << "," << a.y << " " << b.x << "," << b.y << " at " << t;
      ASSERT_TRUE(found->second[0] <= t + 1e-12 && t <= found->second[1] + 1e-12);
    }
  }
}

TEST(LineCells, AShortLineVisitsFewCells) {
  const search::CellGrid grid{{0, 0}, Vec2(1), 1000, 1000};
  int visits = 0;
  search::visit_cells(grid, {500.5, 500.5}, {500.6, 500.6}, 1e-9, [&](int, double, double) { ++visits; });
  EXPECT_EQ(visits, 1);
  visits = 0;
  search::visit_cells(grid, {0.5, 0.5}, {999.5, 999.5}, 1e-9, [&](int, double, double) { ++visits; });
  EXPECT_LE(visits, 3 * 1000);
}

}  // namespace
}  // namespace epura::test::line_cells_test
