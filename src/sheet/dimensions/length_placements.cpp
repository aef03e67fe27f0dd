// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/length_reach.hpp"
#include "dimensions/straight.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr int levels = 24;

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

  [[nodiscard]] double distance(int level, double text_height) const {
    return sign * (outline + first_dimension + level * dimension_step(text_height));
  }
};

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
    return Side{ends, sign, outline, cost_of_extension * (2 * outline - sign * end)};
  };
  return {side_of(first), side_of(-first)};
}

}  // namespace

std::vector<DimensionPlacement> placements_of(const MeasuredLength& length, const MeasuredDimension& measured,
                                              const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  const double upwards = sign_of_offset(left_of(length.along));
  std::vector<DimensionPlacement> placements;
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
  for (const Side& side : sides_of(length, drawing))
    for (int level = 0; level < levels; ++level)
      add_at(side.ends, side.distance(level, style.height(measured.text)), side.cost + cost_of_level * level);
  check(placements.size() == std::size_t{2} * levels * places, "a length has places on both sides");
  return placements;
}

std::vector<DimensionPlacement> placements_in_crowd(const MeasuredLength& length, const MeasuredDimension& measured,
                                                    const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  constexpr double step = 5;        // mm
  constexpr int max_beside = 10;    // steps
  constexpr int max_of_leader = 8;  // steps
  std::vector<DimensionPlacement> placements;
  if (measured.offset) return placements;
  for (const Side& side : sides_of(length, drawing)) {
    const Vec2 out = side.sign * left_of(length.along);
    for (int level = 0; level < levels; ++level) {
      const double distance = side.distance(level, style.height(measured.text));
      const double cost = side.cost + cost_of_level * level;
      for (const double towards : {1.0, -1.0}) {
        for (int i = 0; i < max_beside; ++i)
          placements.push_back(
              {straight_dimension_beside(side.ends, measured.text, distance, {towards > 0, step * i}, style),
               cost + cost_of_beside + cost_of_farther * step * i});
        // Steep enough to leave the extension lines of a narrow length to its sides.
        for (const double slope : {1.0, 2.0}) {
          const Vec2 direction = glm::normalize(towards * length.along + slope * out);
          for (int i = 1; i <= max_of_leader; ++i)
            placements.push_back(
                {straight_dimension_with_leader(side.ends, measured.text, distance, step * i * direction, style),
                 cost + cost_of_leader + cost_of_farther * step * i});
        }
      }
    }
  }
  check(placements.size() > std::size_t{levels}, "a length has less usual places on each level");
  return placements;
}

}  // namespace epura::sheet
