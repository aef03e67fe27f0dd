// The closed forms of tests/property at the sizes that bring down programs whose time grows faster than their output.
#include <gtest/gtest.h>

#include "forms.hpp"

namespace epura::test {
namespace {

TEST(FullSize, StripsOverStrips) { expect_strips_over_strips(1000, 1000, 0.3); }

TEST(FullSize, StackOfPlates) { expect_stack_of_plates(100000, 1e-6); }

TEST(FullSize, ManySlivers) { expect_sliver_plate_to_hide_one_piece(1000000); }

// 335 000 edges with 3 each.
TEST(FullSize, TrianglesWithoutArea) { expect_triangles_without_area_to_change_nothing(136, 4); }

TEST(FullSize, FanWithAManyValentHub) { expect_fan_to_hide_chords(1000000); }

TEST(FullSize, SphereAlongItsAxis) { expect_sphere_along_its_axis(1000, 500); }

TEST(FullSize, SphereFromAnywhere) { expect_sphere_from_anywhere(1000, 500); }

TEST(FullSize, Zonotope) { expect_zonotope(317); }

TEST(FullSize, StackedCopiesAreOneLine) { expect_stacked_copies_to_be_one_line(100000); }

TEST(FullSize, SphereInAStadium) { expect_sphere_in_a_stadium(1000, 500, 1000); }

TEST(FullSize, Needles) { expect_needles(3000); }

}  // namespace
}  // namespace epura::test
