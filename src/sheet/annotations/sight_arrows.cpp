// SPDX-License-Identifier: Apache-2.0
#include "annotations/sight_arrows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

// Lengths in heights of the letters, which are 20 narrow lines: 5 mm for 0.25 mm. As of cutting planes.
constexpr double before_ink = 0.6, sight_arrow_length = 2, sight_head_length = 0.7, sight_letter_gap = 0.8;
constexpr double beside_arrow = 1;  // ink this near to the line of the arrow keeps it away

// How far the ink near a line reaches along it, against the direction of sight.
double reach_against_sight(const drawing::ViewDrawing& view, const SightArrow& arrow, double band) {
  const Vec2 across(-arrow.sight.y, arrow.sight.x);
  double reach = -HUGE_VAL;
  for (const drawing::Segment& segment : view.segments) {
    const Vec2 p = segment.from - arrow.target, q = segment.to - arrow.target;
    const double a = glm::dot(p, across), b = glm::dot(q, across);
    if (std::min(a, b) > band || std::max(a, b) < -band) continue;
    for (const double edge : {-band, band})
      if ((a < edge) != (b < edge)) reach = std::max(reach, -glm::dot(p + (edge - a) / (b - a) * (q - p), arrow.sight));
    if (std::abs(a) <= band) reach = std::max(reach, -glm::dot(p, arrow.sight));
    if (std::abs(b) <= band) reach = std::max(reach, -glm::dot(q, arrow.sight));
  }
  return std::isfinite(reach) ? reach : 0;
}

}  // namespace

Fill sight_head(const Vec2& tip, const Vec2& sight, double length) {
  constexpr double half_angle = 15;  // degrees
  const Vec2 across = Vec2(-sight.y, sight.x) * (length * portable_tan(half_angle * std::numbers::pi / 180));
  const Vec2 foot = tip - length * sight;
  return {{{tip, foot + across, foot - across}}};
}

Layer sight_arrows(const drawing::ViewDrawing& view, std::span<const SightArrow> arrows, const LineWidths& widths) {
  const double height = letter_widths * widths.narrow;
  Layer layer = empty_layer(view.name, scene::SheetLine::arrows, widths);
  for (const SightArrow& arrow : arrows) {
    const double reach = reach_against_sight(view, arrow, beside_arrow * height) + before_ink * height;
    const Vec2 tip = arrow.target - reach * arrow.sight, tail = tip - sight_arrow_length * height * arrow.sight;
    const double head = sight_head_length * height;
    const Vec2 foot = tip - head * arrow.sight;
    layer.fills.push_back(sight_head(tip, arrow.sight, head));
    layer.strokes.push_back(line(tail, foot));
    const Vec2 letter = tail - sight_letter_gap * height * arrow.sight;
    layer.texts.push_back({arrow.letter, letter - Vec2(0, height / 2), height, 0, Align::middle, "arrow"});
  }
  return layer;
}

double sight_arrow_room(const LineWidths& widths) {
  return (before_ink + sight_arrow_length + sight_letter_gap + 0.6) * letter_widths * widths.narrow;
}

}  // namespace epura::sheet
