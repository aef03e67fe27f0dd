// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: what a model file requires is missing beside sizes that were only found, leaders
// cross although one could make way, and symbols stay where their dimensions no longer are.
#include "dimensions/place_items.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "dimensions/costs.hpp"
#include "sheet/marks.hpp"

namespace epura::test::place_items_test {
namespace {

sheet::PlacedDimension text_in(const sheet::Rectangle& box) {
  sheet::PlacedDimension placed;
  placed.zones = {sheet::turned_box(box)};
  placed.text_boxes = placed.zones;
  return placed;
}

sheet::PlacedDimension leader(const Vec2& tip, const Vec2& elbow) {
  sheet::PlacedDimension placed = text_in({elbow, elbow + Vec2(4, 2)});
  placed.leaders = {{tip, elbow}};
  placed.lines = {sheet::line_box(tip, elbow)};
  return placed;
}

// Each place costs one more than the one before it.
sheet::PlacementItem item(sheet::ItemRank rank, const std::vector<sheet::PlacedDimension>& places) {
  sheet::PlacementItem item;
  item.rank = rank;
  item.usual = [places](const sheet::PlacedDimension*) {
    std::vector<sheet::ItemPlacement> placements;
    for (const sheet::PlacedDimension& place : places)
      placements.push_back({place, static_cast<double>(placements.size())});
    return placements;
  };
  return item;
}

sheet::PlacedDimensions place(const std::vector<sheet::PlacementItem>& items) {
  const drawing::ViewDrawing nothing{};
  return sheet::place_items(items, {nothing, {}});
}

constexpr auto found = sheet::ItemRank::found, required = sheet::ItemRank::required, drawn = sheet::ItemRank::drawn;
const sheet::Rectangle here{{0, 0}, {10, 4}}, there{{20, 0}, {30, 4}};

TEST(PlaceItems, WhatIsRequiredTakesThePlacesOfWhatWasFound) {
  sheet::PlacementItem symbol = item(required, {text_in(here)});
  symbol.is_clear = true;
  symbol.order = {1, 0, 0};
  const sheet::PlacedDimensions gone = place({item(found, {text_in(here)}), symbol});
  EXPECT_FALSE(gone[0]);
  EXPECT_TRUE(gone[1]);
  const sheet::PlacedDimensions moved = place({item(found, {text_in(here), text_in(there)}), symbol});
  ASSERT_TRUE(moved[0] && moved[1]);
  EXPECT_EQ(moved[0]->zones.front().centre, there.centre());
  const sheet::PlacedDimensions stays = place({item(drawn, {text_in(here)}), symbol});
  EXPECT_TRUE(stays[0]) << "somebody asked for it";
  EXPECT_FALSE(stays[1]);
  sheet::PlacementItem either = symbol;
  either.usual = item(required, {text_in(here), text_in(there)}).usual;
  const sheet::PlacedDimensions other = place({item(drawn, {text_in(here)}), item(found, {text_in(there)}), either});
  EXPECT_TRUE(other[0]);
  EXPECT_FALSE(other[1]);
  ASSERT_TRUE(other[2]);
  EXPECT_EQ(other[2]->zones.front().centre, there.centre());
}

TEST(PlaceItems, EarlierItemsMoveForLeadersThatWouldCross) {
  const sheet::PlacedDimension across = leader({0, 0}, {10, 10}), aside = leader({0, 0}, {-10, 10});
  sheet::PlacementItem later = item(required, {leader({0, 6}, {10, 4})});
  later.order = {1, 0, 0};
  const sheet::PlacedDimensions placed = place({item(required, {across, aside}), later});
  ASSERT_TRUE(placed[0] && placed[1]);
  EXPECT_EQ(placed[0]->leaders.front().elbow, aside.leaders.front().elbow);
}

TEST(PlaceItems, GuestsStandAtTheirHostsOrNowhere) {
  sheet::PlacementItem guest = item(required, {});
  guest.usual = [](const sheet::PlacedDimension* host) {
    const Vec2 corner = host->zones.front().centre + Vec2(0, 10);
    return std::vector<sheet::ItemPlacement>{{text_in({corner, corner + Vec2(4, 2)}), 0}};
  };
  guest.host = 0;
  guest.order = {1, 0, 0};
  const sheet::PlacedDimensions both = place({item(required, {text_in(there)}), guest});
  ASSERT_TRUE(both[0] && both[1]);
  EXPECT_EQ(both[1]->zones.front().centre, there.centre() + Vec2(2, 11));
  const sheet::PlacedDimensions none = place({item(found, {text_in(here)}), guest, item(drawn, {text_in(here)})});
  EXPECT_FALSE(none[0]);
  EXPECT_FALSE(none[1]);
}

// Where a leader runs along a dimension line, it seems to belong to that.
TEST(PlaceItems, LeadersDoNotRunAlongDimensionLines) {
  const sheet::PlacedDimension along = leader({12, 2}, {40, 2}), across = leader({12, 2}, {5, 20});
  const sheet::PlacedDimensions placed = place({item(drawn, {text_in(there)}), item(drawn, {along, across})});
  ASSERT_TRUE(placed[1]);
  EXPECT_EQ(placed[1]->leaders.front().elbow, across.leaders.front().elbow);
}

TEST(PlaceItems, NoLeaderEndsOnAnotherOne) {
  sheet::PlacedDimension on_it = leader({5, 5.5}, {2, 12}), aside = leader({30, 30}, {40, 40});
  on_it.leaders[0].before = glm::length(Vec2(3, 6.5)) / 13;  // its arrow ends at (5.23, 5), on the other line
  for (const Vec2& elbow : {Vec2(10, 10), Vec2(20, 9.5)}) {
    const sheet::PlacedDimensions placed = place({item(drawn, {leader({0, 0}, elbow)}), item(drawn, {on_it, aside})});
    ASSERT_TRUE(placed[1]);
    EXPECT_EQ(placed[1]->leaders.front().elbow,
              elbow.x < 20 ? aside.leaders.front().elbow : on_it.leaders.front().elbow);
  }
}

// What a leader meets, longer ones on its way meet, too: they are passed over, and the place is the same.
TEST(PlaceItems, FindTheSamePlacesAmongLeadersOnOneWay) {
  std::minstd_rand random(3);
  const auto number = [&](double most) { return std::uniform_real_distribution<double>(0, most)(random); };
  std::size_t moved = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<sheet::PlacementItem> items;
    for (int i = 0; i < 40; ++i) {
      const Vec2 corner(number(60), number(60));
      items.push_back(item(drawn, {text_in({corner, corner + Vec2(4, 3)})}));
    }
    const auto places_with = [&](bool has_ways) {
      std::vector<sheet::PlacementItem> all = items;
      all.push_back(item(required, {}));
      all.back().usual = [=](const sheet::PlacedDimension*) {
        std::vector<sheet::ItemPlacement> places;
        for (std::size_t way = 0; way < 7; ++way)
          for (double length = 4; length < 30; length += 2) {
            const Vec2 tip(30, 30), elbow = tip + length * sheet::turned_to(0.9 * static_cast<double>(way));
            const double cost = 0.5 * length + static_cast<double>(way);
            const auto draw = [=] { return leader(tip, elbow); };
            places.push_back({draw, cost, has_ways ? std::optional(way) : std::nullopt});
          }
        return places;
      };
      return place(all).back();
    };
    const std::optional<sheet::PlacedDimension> one = places_with(true), other = places_with(false);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    EXPECT_EQ(one->leaders.front().elbow, other->leaders.front().elbow);
    moved += glm::distance(one->leaders.front().elbow, Vec2(34, 30)) > 1e-6 ? 1 : 0;
  }
  EXPECT_GE(moved, 10U);
}

}  // namespace
}  // namespace epura::test::place_items_test
