// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: what a model file requires is missing beside sizes that were only found, leaders
// cross although one could make way, and symbols stay where their dimensions no longer are.
#include "dimensions/place_items.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "dimensions/costs.hpp"

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

}  // namespace
}  // namespace epura::test::place_items_test
