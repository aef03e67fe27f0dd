// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/length_reach.hpp"
#include "dimensions/obstacles.hpp"
#include "dimensions/straight.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr int levels = 24;
constexpr double step_beside = 5;  // mm, of texts farther out
constexpr int max_beside = 10;     // steps

}  // namespace

Reach reach_of_ink(const MeasuredLength& length, const drawing::ViewDrawing& drawing) {
  const Vec2 across = left_of(length.along);
  const double slant = glm::dot(length.extension, length.along) / glm::dot(length.extension, across);
  // Coordinates along the dimension line, of the point where the extension line through p meets it, and across.
  const auto local = [&](const Vec2& p) -> Vec2 {
    const double q = glm::dot(p - length.from, across);
    return {glm::dot(p - length.from, length.along) - q * slant, q};
  };
  const Vec2 end = local(length.to);
  const double min = std::min(0.0, end.x), max = std::max(0.0, end.x);
  const bool all = std::min(std::abs(length.along.x), std::abs(length.along.y)) <= along_paper;
  Reach reach;
  reach.add(end.y);
  for (const drawing::Segment& segment : drawing.segments) {
    const Vec2 a = local(segment.from), b = local(segment.to);
    const auto at = [&](double t) { return b.x == a.x ? 0.0 : std::clamp((t - a.x) / (b.x - a.x), 0.0, 1.0); };
    if (!all && (std::max(a.x, b.x) < min || std::min(a.x, b.x) > max)) continue;
    const double s0 = all ? 0 : at(a.x < b.x ? min : max), s1 = all ? 1 : at(a.x < b.x ? max : min);
    reach.add(a.y + s0 * (b.y - a.y));
    reach.add(a.y + s1 * (b.y - a.y));
  }
  check(reach.min <= 0 && reach.max >= 0, "ink reaches to both sides of the line that is measured from");
  return reach;
}

namespace {

/// One side of a view, for dimension lines further and further out.
struct Side {
  MeasuredLength ends;  ///< of the extension lines there
  double sign;          ///< of distances, to the left of the dimension line
  double outline;       ///< distance of the outline
  double cost;          ///< of the extension lines
  bool is_through;      ///< whether these go through the part beyond a diameter

  [[nodiscard]] double distance(int level, double text_height) const {
    return sign * (outline + first_dimension + level * dimension_step(text_height));
  }
};

}  // namespace

double way_to_part(const Vec2& from, const Vec2& to, const drawing::ViewDrawing& drawing) {
  const double length = glm::distance(from, to);
  check(length > 0, "an extension line has a length");
  const Vec2 along = (to - from) / length;
  std::array<std::vector<double>, 2> beside;  // on either side: where on the line pieces begin
  for (const drawing::Segment& segment : drawing.segments) {
    const double a = cross(along, segment.from - from), b = cross(along, segment.to - from);
    if (!segment.visible || a == b || std::min(a, b) > on_line || std::max(a, b) < -on_line) continue;
    const Vec2 nearest = segment.from + std::clamp(a / (a - b), 0.0, 1.0) * (segment.to - segment.from);
    const double at = glm::dot(along, nearest - from);
    if (at <= on_line || at >= length + on_line) continue;
    if (std::min(a, b) < -on_line) beside[0].push_back(at);
    if (std::max(a, b) > on_line) beside[1].push_back(at);
  }
  double nearest = HUGE_VAL;
  for (const double one : beside[0])
    for (const double other : beside[1])
      if (std::abs(one - other) <= on_line) nearest = std::min(nearest, one);
  return nearest;
}

namespace {

bool goes_through_part(const Vec2& from, const Vec2& to, const drawing::ViewDrawing& drawing) {
  return way_to_part(from, to, drawing) < HUGE_VAL;
}

// Below or on the right first.
std::array<Side, 2> sides_of(const MeasuredLength& length, const drawing::ViewDrawing& drawing) {
  const double first = first_side(length.along);
  const auto side_of = [&](double sign) {
    MeasuredLength ends = length;
    if (sign != first && length.opposite) {
      ends.from = (*length.opposite)[0];
      ends.to = (*length.opposite)[1];
    }
    const Reach reach = reach_of_ink(ends, drawing);
    const double outline = sign > 0 ? reach.max : -reach.min;
    const double end = glm::dot(ends.to - ends.from, left_of(ends.along));
    const Vec2 way = sign * outline * left_of(ends.along);
    const bool is_through =
        ends.is_diameter && outline > on_line &&
        (goes_through_part(ends.from, ends.from + way, drawing) || goes_through_part(ends.to, ends.to + way, drawing));
    const double cost = cost_of_extension * (2 * outline - sign * end) + (is_through ? 2 * cost_of_other : 0);
    return Side{ends, sign, outline, cost, is_through};
  };
  return {side_of(first), side_of(-first)};
}

/// A part of a line, mm from a point of it.
struct LineRun {
  double from = 0, to = 0;
};

// What a view draws of a line without a gap at a point of it.
LineRun run_at(const Vec2& point, const Vec2& along, const drawing::ViewDrawing& drawing) {
  std::vector<LineRun> parts{{}};
  for (const drawing::Segment& segment : drawing.segments) {
    const Vec2 a = segment.from - point, b = segment.to - point;
    if (!segment.visible || std::max(std::abs(cross(along, a)), std::abs(cross(along, b))) > on_line) continue;
    const auto [low, high] = std::minmax({glm::dot(along, a), glm::dot(along, b)});
    parts.push_back({low, high});
  }
  std::sort(parts.begin(), parts.end(), [](const LineRun& a, const LineRun& b) { return a.from < b.from; });
  LineRun run = parts.front();
  for (const LineRun& part : parts) {
    if (part.from > run.to + on_line && run.to >= 0) break;
    run = part.from > run.to + on_line ? part : LineRun{run.from, std::max(run.to, part.to)};
  }
  check(run.from <= 0 && run.to >= 0, "a run is on both sides of its point");
  return run;
}

// Its text; with what there is of its line on the side of that, if it stands beyond an end.
std::vector<TurnedBox> zones_beyond(const PlacedDimension& dimension, const MeasuredLength& length) {
  TurnedBox zone = dimension.zones.front();
  const double middle = glm::dot((length.from + length.to) / 2.0 - zone.centre, zone.along);
  const double half = std::abs(glm::dot(length.to - length.from, zone.along)) / 2;
  const double text = glm::dot(dimension.text_boxes.front().centre - zone.centre, zone.along);
  if (std::abs(text - middle) <= half) return dimension.text_boxes;
  const double from = text > middle ? middle + half : -zone.half.x, to = text > middle ? zone.half.x : middle - half;
  zone.centre += (from + to) / 2 * zone.along;
  zone.half.x = (to - from) / 2;
  return {zone};
}

// A diameter on the part itself, where lines of its outline stand for extension lines.
void add_on_part(std::vector<ItemPlacement>& placements, const MeasuredLength& length, const DimensionText& text,
                 const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  const LineRun one = run_at(length.from, length.extension, drawing),
                other = run_at(length.to, length.extension, drawing);
  const double from = std::max(one.from, other.from), size = std::min(one.to, other.to) - from;
  const auto add = [&](PlacedDimension dimension, double cost) {
    // A centre line crosses it between its ends.
    for (const Stroke& line : dimension.strokes)
      dimension.lines.push_back(line_box(line.points.front(), line.points.back()));
    check(dimension.zones.size() == 1 && dimension.text_boxes.size() >= 1, "a dimension has a line and a text");
    dimension.zones = zones_beyond(dimension, length);
    placements.push_back({std::move(dimension), cost_of_crossing_it + cost});
  };
  if (size < 2 * nearest_lines) return;
  const int count = std::max(1, static_cast<int>(size / dimension_step(style.height(text))));
  for (int i = 0; i < count; ++i) {
    MeasuredLength there = length;
    for (Vec2* end : {&there.from, &there.to}) *end += (from + size * (i + 0.5) / count) * length.extension;
    for (int place = 0; place < text_places && fits_inside(length, text, style); ++place)
      add(straight_dimension(there, text, 0, place, style), cost_of_text_place * place);
    for (const bool at_high : {true, false})
      for (int k = 0; k < max_beside; ++k)
        add(straight_dimension_beside(there, text, 0, {at_high, step_beside * k}, style),
            cost_of_beside + cost_of_farther * step_beside * k);
  }
}

}  // namespace

std::vector<ItemPlacement> placements_of(const MeasuredLength& length, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  const double upwards = sign_of_offset(left_of(length.along));
  std::vector<ItemPlacement> placements;
  const int places = fits_inside(length, measured.text, style) ? text_places : 2;
  const auto add_at = [&](const MeasuredLength& ends, double distance, double cost) {
    for (int place = 0; place < places; ++place)
      placements.push_back(
          {straight_dimension(ends, measured.text, distance, place, style), cost + cost_of_text_place * place});
  };
  const auto end_of = [](const MeasuredLength& ends) { return glm::dot(ends.to - ends.from, left_of(ends.along)); };
  if (measured.offset) {
    const double side = *measured.offset < 0 ? -upwards : upwards;
    add_at(length, side * (std::max(0.0, side * end_of(length)) + std::abs(*measured.offset)), 0);
    return placements;
  }
  const std::array<Side, 2> sides = sides_of(length, drawing);
  for (const Side& side : sides)
    for (int level = 0; level < levels; ++level)
      add_at(side.ends, side.distance(level, style.height(measured.text)), side.cost + cost_of_level * level);
  check(placements.size() == std::size_t{2} * levels * places, "a length has places on both sides");
  if (sides[0].is_through && sides[1].is_through && !length.open)
    add_on_part(placements, length, measured.text, drawing, style);
  return placements;
}

namespace {

// Whether the text on a leader is on the dimension line or on an extension line.
bool is_on_own_line(const PlacedDimension& dimension) {
  return std::any_of(dimension.strokes.begin(), dimension.strokes.end(), [&](const Stroke& stroke) {
    return stroke.points.size() == 2 &&
           std::any_of(dimension.text_boxes.begin(), dimension.text_boxes.end(), [&](const TurnedBox& text) {
             return overlap(text, line_box(stroke.points[0], stroke.points[1]));
           });
  });
}

}  // namespace

std::vector<ItemPlacement> placements_in_crowd(const MeasuredLength& length, const MeasuredDimension& measured,
                                               const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  constexpr int max_of_leader = 8;  // steps
  std::vector<ItemPlacement> placements;
  if (measured.offset) return placements;
  for (const Side& side : sides_of(length, drawing)) {
    const Vec2 out = side.sign * left_of(length.along);
    for (int level = 0; level < levels; ++level) {
      const double distance = side.distance(level, style.height(measured.text));
      const double cost = side.cost + cost_of_level * level;
      for (const double towards : {1.0, -1.0}) {
        for (int i = 0; i < max_beside; ++i)
          placements.push_back(
              {straight_dimension_beside(side.ends, measured.text, distance, {towards > 0, step_beside * i}, style),
               cost + cost_of_beside + cost_of_farther * step_beside * i});
        // Steep enough to leave the extension lines of a narrow length to its sides.
        for (const double slope : {1.0, 2.0}) {
          const Vec2 direction = glm::normalize(towards * length.along + slope * out);
          for (int i = 1; i <= max_of_leader; ++i) {
            PlacedDimension there =
                straight_dimension_with_leader(side.ends, measured.text, distance, step_beside * i * direction, style);
            if (!is_on_own_line(there))
              placements.push_back({std::move(there), cost + cost_of_leader + cost_of_farther * step_beside * i});
          }
        }
      }
    }
  }
  check(placements.size() > std::size_t{levels}, "a length has less usual places on each level");
  return placements;
}

}  // namespace epura::sheet
