// SPDX-License-Identifier: Apache-2.0
#include "dimensions/strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

namespace {

/// A straight stroke, as a part of the line through it.
struct LinePart {
  long long angle;    ///< of the line, 1e-9 rad
  double offset;      ///< of the line from the origin, mm
  double begin, end;  ///< along the line, mm
  Vec2 read;          ///< direction of the line
  Stroke* stroke;
  std::size_t first;  ///< of the two points of the stroke, the one at `begin`
};

std::vector<LinePart> straight_parts(PlacedDimensions& placed) {
  std::vector<LinePart> parts;
  for (std::optional<PlacedDimension>& dimension : placed) {
    if (!dimension) continue;
    for (Stroke& stroke : dimension->strokes) {
      if (stroke.points.size() != 2 || stroke.points[0] == stroke.points[1]) continue;
      const Vec2 read = reading_direction(glm::normalize(stroke.points[1] - stroke.points[0]));
      const double from = glm::dot(read, stroke.points[0]), to = glm::dot(read, stroke.points[1]);
      parts.push_back({std::llround(1e9 * portable_atan2(read.y, read.x)), cross(read, stroke.points[0]),
                       std::min(from, to), std::max(from, to), read, &stroke, from < to ? 0U : 1U});
    }
  }
  return parts;
}

// The part of a line inside a rectangle, as parameters from 0 to 1; nothing if it passes by.
std::optional<std::array<double, 2>> part_inside(const Rectangle& box, const Vec2& from, const Vec2& to) {
  double begin = 0, end = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = to[axis] - from[axis];
    if (step == 0 && (from[axis] <= box.min[axis] || from[axis] >= box.max[axis])) return std::nullopt;
    if (step == 0) continue;
    const double at_min = (box.min[axis] - from[axis]) / step, at_max = (box.max[axis] - from[axis]) / step;
    begin = std::max(begin, std::min(at_min, at_max));
    end = std::min(end, std::max(at_min, at_max));
  }
  return begin < end ? std::optional(std::array{begin, end}) : std::nullopt;
}

}  // namespace

void draw_once(PlacedDimensions& placed) {
  constexpr double slack = 1e-6;  // mm
  std::vector<LinePart> parts = straight_parts(placed);
  std::stable_sort(parts.begin(), parts.end(), [](const LinePart& a, const LinePart& b) {
    return std::tie(a.angle, a.offset) < std::tie(b.angle, b.offset);
  });
  const auto is_next_line = [](const LinePart& a, const LinePart& b) {
    return a.angle != b.angle || b.offset - a.offset > slack;
  };
  for (auto first = parts.begin(); first != parts.end();) {
    const auto at = std::adjacent_find(first, parts.end(), is_next_line);
    const auto last = at == parts.end() ? at : std::next(at);
    std::stable_sort(first, last, [](const LinePart& a, const LinePart& b) { return a.begin < b.begin; });
    double drawn = -HUGE_VAL;
    for (; first != last; ++first) {
      std::vector<Vec2>& points = first->stroke->points;
      check(first->begin < first->end, "a part of a line has a length");
      if (first->begin < drawn - slack) points[first->first] += (drawn - first->begin) * first->read;
      if (first->end <= drawn + slack) points.clear();
      drawn = std::max(drawn, first->end);
    }
  }
  for (std::optional<PlacedDimension>& dimension : placed)
    if (dimension) std::erase_if(dimension->strokes, [](const Stroke& stroke) { return stroke.points.empty(); });
}

void interrupt_at(const std::vector<TurnedBox>& letters, PlacedDimensions& placed) {
  constexpr double gap = 0.5;  // mm
  for (const TurnedBox& letter : letters)
    for (std::optional<PlacedDimension>& dimension : placed) {
      if (!dimension) continue;
      std::vector<Stroke> pieces;
      for (Stroke& stroke : dimension->strokes) {
        const Vec2 from = stroke.points.front(), to = stroke.points.back();
        const auto inside = stroke.points.size() == 2 ? part_inside(around(letter).grown(gap), from, to) : std::nullopt;
        check(!inside || ((*inside)[0] >= 0 && (*inside)[1] <= 1), "what is left out of a line lies on it");
        if (!inside) {
          pieces.push_back(std::move(stroke));
          continue;
        }
        const auto at = [&](double part) { return from + part * (to - from); };
        if ((*inside)[0] > 0) pieces.push_back(Stroke{{from, at((*inside)[0])}});
        if ((*inside)[1] < 1) pieces.push_back(Stroke{{at((*inside)[1]), to}});
      }
      dimension->strokes = std::move(pieces);
    }
}

}  // namespace epura::sheet
