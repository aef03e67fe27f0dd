// SPDX-License-Identifier: Apache-2.0
#include "sheet/ink_density.hpp"

#include <gtest/gtest.h>

namespace epura::ink_density_test {
namespace {

drawing::Chain line(std::vector<Vec2> points, bool closed = false) {
  return {std::move(points), closed, true, EdgeKind::crease, {0}};
}

// Lines 2 mm apart, and one across where they are and where they are not.
TEST(InkDensity, IsLengthOverArea) {
  std::vector<drawing::Chain> chains;
  for (int i = 0; i < 20; ++i) chains.push_back(line({{0, 1 + 2.0 * i}, {40, 1 + 2.0 * i}}));
  chains.push_back(line({{0, 0}, {80, 0}}));
  const sheet::InkDensity density(chains, 4);
  EXPECT_NEAR(density.along(chains[10]), 0.5, 0.05);
  EXPECT_NEAR(density.along(line({{20, 2}, {20, 38}})), 0.5, 0.05);
  EXPECT_NEAR(density.along(line({{50, 10}, {70, 10}})), 0, 1e-12);
  EXPECT_NEAR(density.along(line({{20, 10}, {60, 10}})), 0.25, 0.05);
}

// Borders of cells lie beside lines at distances of whole cells.
TEST(InkDensity, CountsLinesAtRoundDistancesOnce) {
  std::vector<drawing::Chain> chains;
  for (int i = 0; i <= 10; ++i) chains.push_back(line({{0, 4.0 * i}, {40, 4.0 * i}}));
  EXPECT_NEAR(sheet::InkDensity(chains, 4).along(chains[5]), 0.25, 0.02);
}

TEST(InkDensity, ClosedLinesAreClosed) {
  const std::vector<drawing::Chain> square = {line({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true)};
  EXPECT_NEAR(sheet::InkDensity(square, 100).along(square[0]), 16 / (100.0 * 100), 1e-12);
  EXPECT_EQ(sheet::InkDensity({}, 1).along(line({{0, 0}, {1, 1}})), 0);
}

}  // namespace
}  // namespace epura::ink_density_test
