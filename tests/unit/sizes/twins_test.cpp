// SPDX-License-Identifier: Apache-2.0
#include "sizes/twins.hpp"

#include <gtest/gtest.h>

namespace epura::test::twins_test {
namespace {

// Axonometric views show bores below their counterbores: there, the note of one hole may stand at another one.
TEST(Twins, EqualCirclesAreAsDeepInTheirHoles) {
  features::PartFeatures features;
  for (const double x : {10.0, 50.0}) {
    features::HoleFeature& hole = features.holes.emplace_back(features::HoleFeature{0, {x, 5, 12}, {0, 0, 1}, 7, true});
    hole.counterbore = features::Recess{12, 6};
    hole.reach = 12;
  }
  scene::DimensionDescription note;
  note.type.value = DimensionType::diameter;
  note.text.value = "2× <>";
  for (const Vec3& place : {features.holes[0].mouth, features.holes[0].begin_of_bore(), Vec3(10, 5, 0)}) {
    note.circle = scene::FeatureCircle{place, {0, 0, 1}, 3.5, {}};
    const std::vector<scene::FeatureCircle> equal = sheet::equal_circles(note, {}, features);
    ASSERT_EQ(equal.size(), 1U);
    EXPECT_EQ(equal[0].centre, Vec3(50, 5, place.z));
  }
}

}  // namespace
}  // namespace epura::test::twins_test
