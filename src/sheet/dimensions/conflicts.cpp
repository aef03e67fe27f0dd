// SPDX-License-Identifier: Apache-2.0
#include "dimensions/conflicts.hpp"

#include <algorithm>
#include <cstddef>

#include "dimensions/costs.hpp"

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

bool meets(const PlacedDimension& dimension, const Neighbours& neighbours) {
  return any_overlap(dimension.text_boxes, neighbours.boxes) || any_overlap(dimension.text_boxes, neighbours.zones) ||
         any_overlap(dimension.lines, neighbours.texts);
}

bool is_in_other_view(const PlacedDimension& dimension, const Neighbours& neighbours) {
  return any_overlap(dimension.zones, neighbours.views) || any_overlap(dimension.lines, neighbours.views);
}

bool is_beyond(const PlacedDimension& dimension, const Neighbours& neighbours) {
  const auto is_out = [&](const TurnedBox& box) { return !neighbours.paper->holds(around(box)); };
  return neighbours.paper && (std::any_of(dimension.zones.begin(), dimension.zones.end(), is_out) ||
                              std::any_of(dimension.lines.begin(), dimension.lines.end(), is_out));
}

bool is_on_lines(const PlacedDimension& dimension, const drawing::ViewDrawing& drawing) {
  return std::any_of(dimension.text_boxes.begin(), dimension.text_boxes.end(),
                     [&](const TurnedBox& text) { return ink_in(text, drawing) > 0; });
}

int faults_of(const PlacedDimension& dimension, const drawing::ViewDrawing& drawing, const Neighbours& neighbours) {
  return (is_beyond(dimension, neighbours) ? 1 : 0) + (meets(dimension, neighbours) ? 1 : 0) +
         (is_in_other_view(dimension, neighbours) ? 1 : 0) + (is_on_lines(dimension, drawing) ? 1 : 0);
}

std::vector<std::string> crossings_of(const PlacedDimensions& placed, const std::vector<std::string>& texts,
                                      const drawing::ViewDrawing& drawing, const Neighbours& neighbours) {
  const auto named = [&](std::size_t i) { return "'" + texts[i] + "'"; };
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i]) continue;
    std::size_t others = 0;
    for (std::size_t j = i + 1; j < placed.size() && others <= max_in_crowd; ++j)
      if (placed[j] && (do_cross(*placed[i], *placed[j]) || have_crossing_leaders(*placed[i], *placed[j])))
        sentences.push_back(named(i) + " and " + (++others <= max_in_crowd ? named(j) : "more dimensions"));
    if (is_in_other_view(*placed[i], neighbours))
      sentences.push_back(named(i) + " and another view or block of the sheet");
    else if (meets(*placed[i], neighbours))
      sentences.push_back(named(i) + " and something else on the sheet");
    if (is_on_lines(*placed[i], drawing)) sentences.push_back(named(i) + " and lines of the view");
  }
  return sentences;
}

}  // namespace epura::sheet
