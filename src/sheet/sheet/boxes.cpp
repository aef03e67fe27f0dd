// SPDX-License-Identifier: Apache-2.0
#include "sheet/boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double border = 1e-6;  // mm

// Half the length of the box's projection onto a direction.
double half_shadow(const TurnedBox& box, const Vec2& line) {
  return box.half.x * std::abs(glm::dot(box.along, line)) + box.half.y * std::abs(glm::dot(left_of(box.along), line));
}

// Half the size of the bounding rectangle.
Vec2 upright_half(const TurnedBox& box) { return {half_shadow(box, {1, 0}), half_shadow(box, {0, 1})}; }

}  // namespace

Rectangle around(const TurnedBox& box) {
  const Vec2 half = upright_half(box);
  check(half.x >= 0 && half.y >= 0, "a box has a size");
  return {box.centre - half, box.centre + half};
}

TurnedBox line_box(const Vec2& from, const Vec2& to) {
  const double length = glm::length(to - from);
  return {(from + to) * 0.5, length > 0 ? (to - from) / length : Vec2(1, 0), {length / 2, 0}};
}

// Two convex figures are disjoint if and only if their projections onto a line perpendicular to one of their sides are.
bool overlap(const TurnedBox& a, const TurnedBox& b) {
  const std::array<Vec2, 4> lines{a.along, left_of(a.along), b.along, left_of(b.along)};
  return std::none_of(lines.begin(), lines.end(), [&](const Vec2& line) {
    return std::abs(glm::dot(a.centre - b.centre, line)) >= half_shadow(a, line) + half_shadow(b, line) - border;
  });
}

TurnedBox box_of(const Text& text, const Lettering& lettering) {
  const double width = lettering.width(text.text, text.height), angle = text.angle * std::numbers::pi / 180;
  const double start = text.align == Align::left ? 0 : text.align == Align::middle ? -width / 2 : -width;
  const Vec2 along(portable_cos(angle), portable_sin(angle));
  const Vec2 half = Vec2(width, text.height) / 2.0;
  return {text.at + (start + half.x) * along + half.y * left_of(along), along, half};
}

std::vector<TurnedBox> boxes_of(const Layer& layer, const Lettering& lettering) {
  std::vector<TurnedBox> boxes;
  for (const Stroke& stroke : layer.strokes) {
    const std::size_t count = stroke.points.size();
    for (std::size_t i = stroke.closed ? 0 : 1; i < count; ++i)
      boxes.push_back(line_box(stroke.points[(i + count - 1) % count], stroke.points[i]));
  }
  for (const Fill& fill : layer.fills)
    for (const std::vector<Vec2>& ring : fill.rings) {
      Rectangle box{ring.front(), ring.front()};
      for (const Vec2& p : ring) box = united(box, {p, p});
      boxes.push_back(turned_box(box));
    }
  for (const Text& text : layer.texts) boxes.push_back(box_of(text, lettering));
  return boxes;
}

int ink_in(const TurnedBox& box, const drawing::ViewDrawing& drawing) {
  const Vec2 half = upright_half(box);
  const Vec2 min = box.centre - half, max = box.centre + half;
  return static_cast<int>(
      std::count_if(drawing.segments.begin(), drawing.segments.end(), [&](const drawing::Segment& s) {
        if (std::max(s.from.x, s.to.x) < min.x || std::min(s.from.x, s.to.x) > max.x) return false;
        if (std::max(s.from.y, s.to.y) < min.y || std::min(s.from.y, s.to.y) > max.y) return false;
        return overlap(box, line_box(s.from, s.to));
      }));
}

}  // namespace epura::sheet
