// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/length_reach.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr int radii = 24;
constexpr int beyond_legs = 8;                   // how many of these are beyond long legs
constexpr double first_radius = 14, longer = 4;  // mm
constexpr double arrows_inside = 3;              // room for two arrows, in lengths of an arrow
constexpr double steepest = 0.5;                 // sine of the slope of a text that falls to the right
constexpr double farthest_past = 1;              // radians of an arc past a leg
constexpr double half_turn = std::numbers::pi;

// From one leg to the other, as angles on paper.
struct Sector {
  Vec2 corner;
  double first, sweep;
};

Sector sector_of(const MeasuredAngle& angle) {
  const auto& [a, b] = angle.legs;
  return {angle.corner, portable_atan2(a.y, a.x),
          angle.arc.value_or(portable_atan2(glm::dot(left_of(a), b), glm::dot(a, b)))};
}

void add_arc(PlacedDimension& dimension, const Stroke& stroke, double half_width) {
  for (std::size_t i = 1; i < stroke.points.size(); ++i) {
    dimension.zones.push_back(line_box(stroke.points[i - 1], stroke.points[i]));
    dimension.zones.back().half.y = half_width;
  }
  dimension.strokes.push_back(stroke);
}

void add_extension_lines(PlacedDimension& dimension, const MeasuredAngle& angle, double radius,
                         const DimensionStyle& style) {
  for (const Vec2& leg : angle.legs) {
    const double length = glm::length(leg);
    if (radius <= length + style.gap()) continue;
    const Vec2 direction = leg / length;
    add_crossable_line(dimension, angle.corner + (length + style.gap()) * direction,
                       angle.corner + (radius + style.overshoot()) * direction);
  }
}

struct DimensionArc {
  Vec2 corner;
  double radius;
};

// Along the arc, or level if the arc is so steep that the text would have to be read from the left.
void set_text_at(PlacedDimension& dimension, const DimensionText& text, const DimensionArc& arc, const Vec2& spoke,
                 const DimensionStyle& style) {
  const Vec2 read = reading_direction(left_of(spoke));
  const double width = style.width(text);
  if (read.y < -steepest) {
    const double reach = (std::abs(spoke.x) * width + std::abs(spoke.y) * style.height(text)) / 2 + 2 * style.above();
    const Vec2 middle = arc.corner + (arc.radius + reach) * spoke;
    return set_text(dimension, text, {middle, {1, 0}, -style.height(text) / 2}, style);
  }
  const bool inside = glm::dot(left_of(read), spoke) < 0;  // then the arc rises beside the text
  const double rise = style.above() + (inside ? width * width / (8 * arc.radius) : 0);
  set_text(dimension, text, {arc.corner + arc.radius * spoke, read, rise}, style);
}

// From a leg to the middle of a text past it, radians.
double lead_of(const DimensionText& text, double radius, const DimensionStyle& style) {
  return std::min((style.arrow() + style.above() + style.width(text) / 2) / radius, farthest_past);
}

// Adds an arc with arrows and text; `place`: the text is at its middle (0), past its end (1) or its beginning (-1), or
// in the middle of its last half (2) or its first (-2).
void add_dimension_arc(PlacedDimension& dimension, const Sector& sector, const DimensionText& text, double radius,
                       int place, const DimensionStyle& style) {
  const auto [corner, first, sweep] = sector;
  check(radius >= 0, "the arc of an angle has a radius");
  const double turn = sweep < 0 ? -1 : 1;
  const bool outward = radius * std::abs(sweep) >= arrows_inside * style.arrow();
  const double tail = outward ? 0 : std::min(2 * style.arrow() / radius, farthest_past) * turn;
  const double lead = lead_of(text, radius, style) * turn;
  const double middle = place == 1    ? first + sweep + lead
                        : place == -1 ? first - lead
                                      : first + sweep / 2 + place * sweep / 8;
  add_arc(dimension,
          arc_at(corner, radius, place == -1 ? first - 2 * lead : first - tail,
                 place == 1 ? first + sweep + 2 * lead : first + sweep + tail),
          style.above());
  for (const double side : {-1.0, 1.0}) {
    const double end = side < 0 ? first : first + sweep;
    const Vec2 forward = side * turn * left_of(turned_to(end));
    dimension.arrows.push_back(arrow_at(corner + radius * turned_to(end), outward ? forward : -forward, style));
  }
  set_text_at(dimension, text, {corner, radius}, turned_to(middle), style);
  dimension.zones.push_back(dimension.text_boxes.back());
}

PlacedDimension arc_dimension(const MeasuredAngle& angle, const DimensionText& text, double radius, int place,
                              const DimensionStyle& style) {
  PlacedDimension dimension;
  add_extension_lines(dimension, angle, radius, style);
  add_dimension_arc(dimension, sector_of(angle), text, radius, place, style);
  return dimension;
}

PlacedDimension angular_dimension(const MeasuredAngle& angle, const DimensionText& text, double radius, int place,
                                  const DimensionStyle& style) {
  PlacedDimension dimension = arc_dimension(angle, text, radius, place, style);
  const auto [corner, first, sweep] = sector_of(angle);
  dimension.objects = {
      {DimensionShape::angular,
       {corner, corner + angle.legs[0], corner + angle.legs[1], corner + radius * turned_to(first + sweep / 2)}}};
  return dimension;
}

// Up to a right angle, extension lines are parallel to the bisector, and the dimension line is as long as the arc;
// beyond, they are radial. ISO 129-1.
PlacedDimension length_of_arc(const MeasuredAngle& angle, const DimensionText& text, double distance, int place,
                              const DimensionStyle& style) {
  const Sector sector = sector_of(angle);
  const double radius = glm::length(angle.legs[0]);
  if (std::abs(sector.sweep) > half_turn / 2 + 1e-9) return arc_dimension(angle, text, radius + distance, place, style);
  const Vec2 out = turned_to(sector.first + sector.sweep / 2);
  PlacedDimension dimension;
  for (const Vec2& leg : angle.legs)
    add_crossable_line(dimension, angle.corner + leg + style.gap() * out,
                       angle.corner + leg + (distance + style.overshoot()) * out);
  add_dimension_arc(dimension, {sector.corner + distance * out, sector.first, sector.sweep}, text, radius, place,
                    style);
  return dimension;
}

// How many lines of a view an arc of this radius crosses between the legs; many count as a few.
int lines_across(const drawing::ViewDrawing& drawing, const Sector& sector, double radius) {
  constexpr int most = 6;
  constexpr double beside = 0.03;  // radians from a leg
  const double half = std::abs(sector.sweep) / 2;
  const Vec2 middle = turned_to(sector.first + sector.sweep / 2);
  int count = 0;
  for (const drawing::Segment& segment : drawing.segments) {
    const Vec2 from = segment.from - sector.corner, to = segment.to - sector.corner;
    const double near = glm::length(from), far = glm::length(to);
    if ((near < radius) == (far < radius)) continue;
    const Vec2 at = from + (radius - near) / (far - near) * (to - from);
    if (std::abs(portable_atan2(cross(middle, at), glm::dot(middle, at))) < half - beside && ++count == most) break;
  }
  return count;
}

// By leg: from which radius on its extension line goes through the part.
std::array<double, 2> radii_of_part(const MeasuredAngle& angle, const drawing::ViewDrawing& drawing) {
  std::array<double, 2> radii{};
  const double farthest = glm::distance(drawing.box.min, drawing.box.max);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 end = angle.corner + angle.legs[i];
    radii[i] = glm::length(angle.legs[i]) + way_to_part(end, end + farthest * glm::normalize(angle.legs[i]), drawing);
  }
  return radii;
}

// At one corner.
void add_at_corner(std::vector<ItemPlacement>& placements, const MeasuredAngle& angle,
                   const MeasuredDimension& measured, const drawing::ViewDrawing& drawing,
                   const DimensionStyle& style) {
  const double sweep = std::abs(sector_of(angle).sweep);
  const std::array<double, 2> part = radii_of_part(angle, drawing);
  check(sweep > 0, "an angle is not zero");
  const auto cost_past = [&](int place, double radius) {
    const auto [corner, first, turn] = sector_of(angle);
    const double past = std::copysign(2 * lead_of(measured.text, radius, style), turn);
    const Sector tail{corner, place == 1 ? first + turn : first - past, past};
    return cost_of_crossing * lines_across(drawing, tail, radius);
  };
  for (int k = 0; k < (measured.offset ? 1 : radii); ++k) {
    const double offset = measured.offset ? std::abs(*measured.offset) : 0;
    if (angle.arc) {
      const double distance = measured.offset ? offset : first_dimension + longer * k;
      const double length = glm::length(angle.legs[0]) * sweep;
      for (const int place : {0, 1, -1}) {
        const bool fits = length > style.width(measured.text) + 2 * style.above();
        placements.push_back({length_of_arc(angle, measured.text, distance, place, style),
                              cost_of_length * distance + (place == 0 ? (fits ? 0 : 2 * cost_outside) : cost_outside)});
      }
      continue;
    }
    double radius = measured.offset ? offset : first_radius + longer * k;
    // The last ones are outside the legs.
    if (!measured.offset && k >= radii - beyond_legs)
      radius = std::max(radius, std::max(glm::length(angle.legs[0]), glm::length(angle.legs[1])) + first_dimension +
                                    longer * (k - radii + beyond_legs));
    const double width = style.width(measured.text) + 2 * style.above();
    const bool room = radius * sweep > width;
    const double crossed =
        cost_of_crossing * std::max(lines_across(drawing, sector_of(angle), radius) - 1, 0) +
        cost_of_other * static_cast<double>(std::ranges::count_if(part, [radius](double at) { return at < radius; }));
    for (const int place : {0, 1, -1, 2, -2}) {
      const bool is_aside = std::abs(place) == 2;
      if (is_aside && radius * sweep / 2 <= width) continue;
      const double crowded = place == 0 ? (room ? 0 : 2 * cost_outside)
                             : is_aside ? cost_of_inside
                                        : cost_outside + cost_past(place, radius);
      placements.push_back(
          {angular_dimension(angle, measured.text, radius, place, style), cost_of_length * radius + crowded + crossed});
    }
  }
}

}  // namespace

std::vector<ItemPlacement> placements_of(const MeasuredAngle& angle, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  std::vector<ItemPlacement> placements;
  add_at_corner(placements, angle, measured, drawing, style);
  const std::size_t own = placements.size();
  if (angle.equal && !measured.offset)
    add_at_corner(placements, {angle.equal->at, angle.equal->legs}, measured, drawing, style);
  for (std::size_t i = own; i < placements.size(); ++i) placements[i].cost += cost_outside;
  check(placements.size() >= std::size_t{3} * (measured.offset ? 1 : radii), "each arc has places for its text");
  return placements;
}

}  // namespace epura::sheet
