// SPDX-License-Identifier: Apache-2.0
#include "drawing/symmetry.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace epura::drawing::symmetry_test {
namespace {

constexpr double slack = 0.25;

ViewDrawing drawing_of(const std::vector<std::array<Vec2, 2>>& lines, bool visible = true) {
  ViewDrawing drawing;
  for (const auto& [from, to] : lines) {
    Segment& segment = drawing.segments.emplace_back();
    segment.from = from;
    segment.to = to;
    segment.visible = visible;
  }
  return drawing;
}

TEST(Symmetry, ImagesOfLinesAreLines) {
  // A house, mirrored about x = 20; one side is in two parts.
  const ViewDrawing house = drawing_of({{{{0, 0}, {40, 0}}},
                                        {{{0, 0}, {0, 30}}},
                                        {{{40, 0}, {40, 12}}},
                                        {{{40, 12}, {40, 30}}},
                                        {{{0, 30}, {20, 50}}},
                                        {{{20, 50}, {40, 30}}}});
  EXPECT_EQ(length_without_mirror_image(house, 0, 20, slack), 0);
  // About y = 25, nothing but the middle of both sides has an image; the roof lies where no wall is.
  EXPECT_GT(length_without_mirror_image(house, 1, 25, slack), 100);
}

TEST(Symmetry, WhatIsMissingIsMeasured) {
  const ViewDrawing one = drawing_of({{{{-10, 0}, {-10, 20}}}, {{{10.2, 5}, {10.2, 20}}}});
  EXPECT_NEAR(length_without_mirror_image(one, 0, 0, slack), 5, 0.51);
  EXPECT_NEAR(length_without_mirror_image(one, 0, 0, 0.1), 35, 1e-9);
}

TEST(Symmetry, HiddenLinesDoNotCount) {
  EXPECT_EQ(length_without_mirror_image(drawing_of({{{{3, 0}, {5, 7}}}}, false), 0, 0, slack), 0);
  EXPECT_EQ(length_without_mirror_image({}, 0, 0, slack), 0);
}

// Far from all lines, and in a drawing of which all lines are one point.
TEST(Symmetry, ImagesBeyondTheDrawingAreMissing) {
  EXPECT_NEAR(length_without_mirror_image(drawing_of({{{{0, 0}, {8, 6}}}}), 0, 1e6, slack), 10, 1e-9);
  EXPECT_EQ(length_without_mirror_image(drawing_of({{{{2, 2}, {2, 2}}}}), 0, 2, slack), 0);
}

}  // namespace
}  // namespace epura::drawing::symmetry_test
