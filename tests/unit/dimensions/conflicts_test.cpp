// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "dimensions/obstacles.hpp"
#include "sheet/boxes.hpp"

namespace epura::test::conflicts_test {
namespace {

sheet::PlacedDimension with_text_at(const Vec2& place) {
  sheet::PlacedDimension one;
  one.zones = one.text_boxes = {sheet::turned_box({place, place + Vec2(10, 5)})};
  return one;
}

TEST(Conflicts, AreOfItemsWithEachOtherAndWithWhatIsThere) {
  const drawing::ViewDrawing nothing{};
  sheet::Neighbours other_view;
  other_view.views = {sheet::turned_box({{30, 0}, {90, 50}})};
  const sheet::PlacedDimensions apart{with_text_at({0, 0}), std::nullopt, with_text_at({15, 0})},
      on_each_other{with_text_at({0, 0}), std::nullopt, with_text_at({8, 0})}, inside{with_text_at({28, 0})};
  EXPECT_FALSE(sheet::have_conflicts({}, {nothing, other_view}));
  EXPECT_FALSE(sheet::have_conflicts(apart, {nothing, other_view}));
  EXPECT_TRUE(sheet::have_conflicts(on_each_other, {nothing, other_view}));
  EXPECT_TRUE(sheet::have_conflicts(inside, {nothing, other_view}));
  EXPECT_FALSE(sheet::have_conflicts(inside, {nothing, {}}));
}

}  // namespace
}  // namespace epura::test::conflicts_test
