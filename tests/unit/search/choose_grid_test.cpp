// SPDX-License-Identifier: Apache-2.0
#include "search/choose_grid.hpp"

#include <gtest/gtest.h>

namespace epura::test::choose_grid_test {
namespace {

search::Cuts things(std::size_t count, const Vec2& box, const Vec2& page) {
  search::Cuts cuts;
  for (std::size_t i = 0; i < count; ++i) cuts.add(box, page);
  return cuts;
}

constexpr search::GridLimits limits{1024, 1e-6, 8, 128};

TEST(ChooseGrid, SmallThingsGetSquareCells) {
  const search::PageBox page{{1, 2}, {5, 4}};
  const search::Cuts small = things(1000, {0.01, 0.01}, {4, 2});
  const search::CellGrid grid = search::choose_grid(page, small, small, limits);
  EXPECT_EQ(grid.count(), 1024);
  EXPECT_LE(std::max(grid.side.x, grid.side.y), 2 * std::min(grid.side.x, grid.side.y));
  EXPECT_EQ(grid.origin + grid.side * Vec2(grid.columns, grid.rows), page.max);
}

TEST(ChooseGrid, LongUprightLinesGetLongUprightCells) {
  const search::PageBox page{{0, 0}, {1, 1}};
  const search::CellGrid grid =
      search::choose_grid(page, things(1000, {0, 1}, {1, 1}), things(10, {0, 0}, {1, 1}), limits);
  EXPECT_GE(grid.columns, 128);
  EXPECT_LE(grid.rows, 8);
}

TEST(ChooseGrid, LargeTrianglesAreNotCutTooOften) {
  const search::PageBox page{{0, 0}, {1, 1}};
  const search::CellGrid grid =
      search::choose_grid(page, things(1000, {0, 0}, {1, 1}), things(1000, {1, 1}, {1, 1}), limits);
  EXPECT_LE(grid.count(), 128);
  EXPECT_GE(grid.count(), 32);
}

TEST(ChooseGrid, NothingAndAPointGetOneCell) {
  EXPECT_EQ(search::choose_grid({{0, 0}, {0, 0}}, {}, {}, limits).count(), 1);
  const search::GridLimits coarse{1024, 1, 8, 128};
  EXPECT_EQ(search::choose_grid({{3, 3}, {3, 3}}, things(5, {0, 0}, {1, 1}), {}, coarse).count(), 1);
}

}  // namespace
}  // namespace epura::test::choose_grid_test
