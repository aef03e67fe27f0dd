// SPDX-License-Identifier: Apache-2.0
// The closed forms of tests/property at the sizes that bring down programs whose time grows faster than their output.
#include <gtest/gtest.h>

#include "measured.hpp"

namespace epura::test::full_size_test {
namespace {

using namespace stability;

const Lab lab;

TEST(FullSize, StripsOverStrips) { expect_right(strips_over_strips(lab, 1000, 1000, 0.3)); }

TEST(FullSize, StackOfPlates) { expect_right(stack_of_plates(lab, 100000, 1e-6)); }

TEST(FullSize, PlatesAlongALine) { expect_right(plates_along_a_line(lab, 100000, 1e-6)); }

TEST(FullSize, ManySlivers) { expect_right(sliver_plate(lab, 1000000)); }

// 335 000 edges with 3 each.
TEST(FullSize, TrianglesWithoutArea) { expect_right(triangles_without_area(lab, 136, 4)); }

TEST(FullSize, FanWithAManyValentHub) { expect_right(fan_over_chords(lab, 1000000)); }

TEST(FullSize, SphereAlongItsAxis) { expect_right(sphere_along_its_axis(lab, 1000, 500)); }

TEST(FullSize, SphereFromAnywhere) {
  for (const double distance : {1.5, 10.0, HUGE_VAL}) expect_right(sphere_from_anywhere(lab, 1000, 500, distance));
}

TEST(FullSize, Zonotope) { expect_right(zonotope(lab, 317)); }

TEST(FullSize, StackedCopiesAreOneLine) { expect_right(stacked_copies(lab, 100000)); }

TEST(FullSize, SphereInAStadium) { expect_right(sphere_in_a_stadium(lab, 1000, 500, 1000)); }

TEST(FullSize, Needles) { expect_right(needles(lab, 3000), 1); }

}  // namespace
}  // namespace epura::test::full_size_test
