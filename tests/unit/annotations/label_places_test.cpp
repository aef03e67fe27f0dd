// SPDX-License-Identifier: Apache-2.0
#include "annotations/label_places.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace epura::sheet::label_places_test {
namespace {

const Rectangle area{{0, 0}, {100, 80}};

Label label_at(const Vec2& at, const Vec2& size = {8, 3.5}) { return {size, {{at}}}; }

TEST(LabelPlaces, AreBesideTheirAnchors) {
  LabelRoom room(area);
  const auto places = room.place(std::vector{label_at({50, 40})});
  ASSERT_TRUE(places[0]);
  EXPECT_FALSE(places[0]->has_leader);
  // On the right above it, 0.8 mm away.
  EXPECT_NEAR(places[0]->box.min.x, 50 + 0.8 / std::sqrt(2), 1e-9);
  EXPECT_NEAR(places[0]->box.min.y, 40 + 0.8 / std::sqrt(2), 1e-9);
  EXPECT_EQ(places[0]->box.size(), Vec2(8, 3.5));
}

// Of areas, on them; in a direction, there.
TEST(LabelPlaces, FollowWishes) {
  LabelRoom room(area);
  Label inside = label_at({20, 40});
  inside.inside = true;
  const Label outwards{{8, 3.5}, {{{70, 40}, {-1, 0}}}};
  const auto places = room.place(std::vector{inside, outwards});
  EXPECT_EQ(places[0]->box.centre(), Vec2(20, 40));
  EXPECT_NEAR(places[1]->box.max.x, 70 - 0.8, 1e-9);
  EXPECT_NEAR(places[1]->box.centre().y, 40, 1e-9);
}

TEST(LabelPlaces, AreInTheRoom) {
  LabelRoom room(area);
  for (const Vec2& corner : {Vec2(0, 0), Vec2(100, 0), Vec2(100, 80), Vec2(0, 80)}) {
    const auto places = room.place(std::vector{label_at(corner)});
    ASSERT_TRUE(places[0]);
    EXPECT_TRUE(area.holds(places[0]->box));
  }
  EXPECT_FALSE(room.place(std::vector{label_at({50, 40}, {120, 3.5})})[0]) << "too long for the room";
}

// A label beyond the line would seem to name that.
TEST(LabelPlaces, HaveNoLineBeforeTheirAnchors) {
  LabelRoom room(area);
  room.add_line({0, 41}, {100, 41});
  room.add_line({0, 39}, {100, 39});
  room.add_line({49, 0}, {49, 80});
  const auto places = room.place(std::vector{label_at({50, 40})});
  ASSERT_TRUE(places[0]);
  // Either on lines or beyond one: to the right, since the anchor is between the lines there.
  EXPECT_GT(places[0]->box.min.x, 50);
}

TEST(LabelPlaces, DoNotMeetWhereManyStand) {
  LabelRoom room(area);
  std::vector<Label> labels;
  for (int i = 0; i < 12; ++i) labels.push_back(label_at({45 + 3.0 * (i % 4), 38 + 3.0 * (i / 4)}));
  const auto places = room.place(labels);
  for (const auto& place : places) ASSERT_TRUE(place);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(places[i]->box.overlaps(places[j]->box));
    if (!places[i]->has_leader) continue;
    for (std::size_t j = 0; j < places.size(); ++j)
      EXPECT_TRUE(j == i || !overlap(line_box(places[i]->tie[0], places[i]->tie[1]), turned_box(places[j]->box)));
  }
}

// The only place of the second label is the first one's best.
TEST(LabelPlaces, MoveForOthers) {
  LabelRoom room({{0, 0}, {20, 8}});
  Label first = label_at({10, 4}, {6, 3}), second = label_at({10, 4}, {6, 3});
  const auto places = room.place(std::vector{first, second});
  ASSERT_TRUE(places[0] && places[1]);
  EXPECT_FALSE(places[0]->box.overlaps(places[1]->box));
}

TEST(LabelPlaces, AreClearOfLettering) {
  LabelRoom room(area);
  room.add_lettering(turned_box({{40, 30}, {60, 50}}));
  const auto places = room.place(std::vector{label_at({50, 40})});
  ASSERT_TRUE(!places[0] || !places[0]->box.overlaps({{40, 30}, {60, 50}}));
}

}  // namespace
}  // namespace epura::sheet::label_places_test
