// SPDX-License-Identifier: Apache-2.0
#include "dimensions/conflicts.hpp"

#include <algorithm>

namespace epura::sheet {

namespace {

bool any_overlap(const std::vector<TurnedBox>& boxes, const TurnedBox& box) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const TurnedBox& other) { return overlap(other, box); });
}

bool any_overlap(const std::vector<TurnedBox>& some, const std::vector<TurnedBox>& others) {
  return std::any_of(some.begin(), some.end(), [&](const TurnedBox& box) { return any_overlap(others, box); });
}

}  // namespace

bool do_cross(const PlacedDimension& a, const PlacedDimension& b) {
  const auto covers = [](const PlacedDimension& one, const PlacedDimension& other) {
    return any_overlap(one.text_boxes, other.lines) || any_overlap(one.text_boxes, other.zones);
  };
  return any_overlap(a.zones, b.zones) || covers(a, b) || covers(b, a);
}

bool have_crossing_leaders(const PlacedDimension& a, const PlacedDimension& b) {
  return std::any_of(a.leaders.begin(), a.leaders.end(), [&](const LeaderLine& one) {
    return std::any_of(b.leaders.begin(), b.leaders.end(), [&](const LeaderLine& other) {
      return overlap(line_box(one.tip, one.elbow), line_box(other.tip, other.elbow));
    });
  });
}

}  // namespace epura::sheet
