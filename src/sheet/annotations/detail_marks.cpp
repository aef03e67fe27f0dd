// SPDX-License-Identifier: Apache-2.0
#include "annotations/detail_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/place_items.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

constexpr double gap = 1;  // mm between a letter and all ink
constexpr double detail_leader_step = 3, longest_leader = 45;
// Preferred directions first: up to the right, as a reader expects it.
constexpr std::array<int, 16> letter_directions = {45,  135, 315, 225, 30, 60, 120, 150,
                                                   330, 300, 210, 240, 0,  90, 180, 270};
constexpr int corners_of_circle = 360;

// Distance from the centre to the boundary in a direction.
double reach_of(const drawing::Boundary& boundary, const Vec2& direction) {
  if (boundary.round) return boundary.half.x;
  double reach = HUGE_VAL;
  for (const int axis : {0, 1})
    if (std::abs(direction[axis]) > 1e-12) reach = std::min(reach, boundary.half[axis] / std::abs(direction[axis]));
  return reach;
}

// What letters must not touch.
Neighbours around_letters(const LetterRoom& room, std::span<const Stroke> boundaries, const Lettering& lettering) {
  Neighbours around;
  around.paper = room.area;
  around.boxes = room.reserved;
  const auto add = [&](const std::vector<TurnedBox>& boxes) {
    around.boxes.insert(around.boxes.end(), boxes.begin(), boxes.end());
  };
  for (const Layer& layer : room.drawn) add(boxes_of(layer, lettering));
  Layer lines;
  lines.strokes.assign(boundaries.begin(), boundaries.end());
  add(boxes_of(lines, lettering));
  return around;
}

// Beside the boundary, or at the end of a leader, which may cross what it likes.
PlacedDimension letter_at(const drawing::Boundary& boundary, int degrees, double leader, const Vec2& half) {
  const Vec2 direction = turned_to(degrees * std::numbers::pi / 180);
  const Vec2 from = boundary.centre + reach_of(boundary, direction) * direction;
  const double to_middle = std::abs(direction.x) * half.x + std::abs(direction.y) * half.y + gap;
  PlacedDimension letter;
  letter.zones = {{from + (leader + to_middle) * direction, {1, 0}, half + gap}};
  letter.text_boxes = letter.zones;
  if (leader > 0) letter.strokes.push_back(line(from, from + leader * direction));
  return letter;
}

// The nearest places first, in the preferred directions.
PlacementItem letter_item(const drawing::Boundary& boundary, const Vec2& half) {
  constexpr double later_direction = 0.05;
  PlacementItem item;
  item.usual = [=](const PlacedDimension*) {
    std::vector<ItemPlacement> placements;
    for (double leader = 0; leader <= longest_leader; leader += detail_leader_step)
      for (std::size_t i = 0; i < letter_directions.size(); ++i)
        placements.push_back({letter_at(boundary, letter_directions[i], leader, half),
                              cost_of_way * leader + later_direction * static_cast<double>(i)});
    return placements;
  };
  return item;
}

}  // namespace

Stroke boundary_line(const drawing::Boundary& boundary) {
  if (!boundary.round) return outline(box_of(boundary));
  Stroke circle;
  circle.closed = true;
  const double radius = boundary.half.x;
  for (int i = 0; i < corners_of_circle; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners_of_circle;
    circle.points.push_back(boundary.centre + radius * Vec2(portable_cos(angle), portable_sin(angle)));
  }
  circle.curves = {{0, corners_of_circle, boundary.centre, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi}};
  return circle;
}

Layer detail_marks(const std::string& view, std::span<const DetailMark> marks, const LetterRoom& room,
                   const Lettering& lettering, const LineWidths& widths) {
  Layer layer = empty_layer(view, scene::SheetLine::detail, widths);
  const double height = letter_widths * widths.narrow;
  std::vector<Stroke> boundaries;
  for (const DetailMark& mark : marks) boundaries.push_back(boundary_line(mark.boundary));
  std::vector<PlacementItem> items;
  for (const DetailMark& mark : marks)
    items.push_back(letter_item(mark.boundary, Vec2(lettering.width(mark.name, height), height) / 2.0));
  const PlacedDimensions letters =
      place_items(items, {drawing::ViewDrawing(), around_letters(room, boundaries, lettering)});
  for (std::size_t i = 0; i < marks.size(); ++i) {
    append(layer.strokes, letters[i]->strokes);
    const Vec2 base = letters[i]->zones.front().centre - Vec2(0, height / 2);
    layer.texts.push_back({marks[i].name, base, height, 0, Align::middle, "detail"});
  }
  append(layer.strokes, std::move(boundaries));
  check(layer.texts.size() == marks.size() && layer.strokes.size() <= 2 * marks.size(),
        "a detail has a boundary, a letter, and a leader at most");
  return layer;
}

}  // namespace epura::sheet
