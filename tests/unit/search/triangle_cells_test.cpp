// SPDX-License-Identifier: Apache-2.0
#include "search/triangle_cells.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace epura::test::triangle_cells_test {
namespace {

double uniform(std::mt19937& random, double min, double max) {
  return min + (max - min) * (static_cast<double>(random()) / 4294967296.0);
}

double area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool contains(const std::array<Vec2, 3>& t, const Vec2& p) {
  const double sign = area(t[0], t[1], t[2]) < 0 ? -1 : 1;
  return sign * area(t[0], t[1], p) >= 0 && sign * area(t[1], t[2], p) >= 0 && sign * area(t[2], t[0], p) >= 0;
}

// Large and small, slim and nearly level ones, with corners on the lines of the grid.
std::array<Vec2, 3> random_triangle(std::mt19937& random) {
  const double size = std::pow(2.0, -static_cast<double>(random() % 6));
  const bool on_lines = random() % 3 == 0;
  const Vec2 middle(uniform(random, -1, 9), uniform(random, -1, 7));
  std::array<Vec2, 3> corners;
  for (Vec2& corner : corners) {
    corner = middle + 8 * size * Vec2(uniform(random, -1, 1), uniform(random, -1, 1));
    if (on_lines) corner = glm::round(corner);
  }
  if (random() % 4 == 0) corners[1].y = corners[0].y + 1e-12;
  return corners;
}

struct Cells {
  std::vector<char> touched, inner;
};

Cells cells_of(const search::CellGrid& grid, const std::array<Vec2, 3>& corners, const Vec2& slack) {
  Cells cells{std::vector<char>(grid.count(), 0), std::vector<char>(grid.count(), 0)};
  search::TriangleOnGrid(grid, corners, slack).visit_rows([&](const search::RowOfCells& row) {
    for (int column = row.from; column <= row.to; ++column) cells.touched[grid.cell(column, row.row)] = 1;
    for (int column = row.inner_from; column <= row.inner_to; ++column) cells.inner[grid.cell(column, row.row)] = 1;
  });
  return cells;
}

TEST(TriangleCells, EveryPlaceOfTheTriangleIsInATouchedCell) {
  std::mt19937 random(1);
  const search::CellGrid grid{{0, 0}, {1, 0.5}, 8, 12};
  for (int round = 0; round < 3000; ++round) {
    const std::array<Vec2, 3> corners = random_triangle(random);
    const Cells cells = cells_of(grid, corners, Vec2(1e-9));
    for (int i = 0; i < 60; ++i) {
      double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec2 p = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
      if (p.x < 0 || p.y < 0 || p.x > 8 || p.y > 6) continue;
      ASSERT_TRUE(cells.touched[grid.cell(grid.column(p.x), grid.row(p.y))]) << round;
    }
  }
}

TEST(TriangleCells, InnerCellsLieWhollyInside) {
  std::mt19937 random(2);
  const search::CellGrid grid{{0, 0}, {1, 0.5}, 8, 12};
  int inner = 0;
  for (int round = 0; round < 12000; ++round) {
    const std::array<Vec2, 3> corners = random_triangle(random);
    const Cells cells = cells_of(grid, corners, Vec2(1e-6));
    for (int cell = 0; cell < grid.count(); ++cell) {
      if (!cells.inner[cell]) continue;
      ++inner;
      ASSERT_TRUE(cells.touched[cell]) << round;
      ASSERT_TRUE(search::TriangleOnGrid(grid, corners, Vec2(1e-6)).may_hold_cells()) << round;
      for (const Vec2& corner : {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, -1), Vec2(1, 1)})
        ASSERT_TRUE(contains(corners, grid.middle(cell) + corner * (grid.side / 2.0))) << round << ", cell " << cell;
    }
  }
  EXPECT_GT(inner, 10000);
}

TEST(TriangleCells, ACellThatIsWideAndLowLiesInsideToo) {
  // One row of narrow columns, as long parallel lines get them.
  const search::CellGrid grid{{0, 0}, {0.01, 1}, 100, 1};
  const Cells cells = cells_of(grid, {Vec2(-1, -1), Vec2(5, -1), Vec2(-1, 5)}, Vec2(1e-6));
  EXPECT_EQ(std::count(cells.inner.begin(), cells.inner.end(), 1), 100);
}

TEST(TriangleCells, ATriangleWithLessThanTwoCellsOfAreaHoldsNone) {
  const search::CellGrid grid{{0, 0}, {1, 1}, 8, 8};
  EXPECT_FALSE(search::TriangleOnGrid(grid, {Vec2(0, 0), Vec2(8, 7), Vec2(7, 6.2)}, Vec2(1e-6)).may_hold_cells());
  EXPECT_FALSE(search::TriangleOnGrid(grid, {Vec2(0, 0), Vec2(1.9, 0), Vec2(0, 1.9)}, Vec2(1e-6)).may_hold_cells());
  EXPECT_TRUE(search::TriangleOnGrid(grid, {Vec2(0, 0), Vec2(2.1, 0), Vec2(0, 2.1)}, Vec2(1e-6)).may_hold_cells());
}

TEST(TriangleCells, ATriangleBesideTheGridVisitsNothing) {
  const search::CellGrid grid{{0, 0}, {1, 1}, 4, 4};
  const Cells cells = cells_of(grid, {Vec2(5, 1), Vec2(9, 1), Vec2(6, 3)}, Vec2(1e-6));
  EXPECT_EQ(std::count(cells.touched.begin(), cells.touched.end(), 1), 0);
}

}  // namespace
}  // namespace epura::test::triangle_cells_test
