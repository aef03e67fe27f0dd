// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/shown_circle.hpp"
#include "dimensions/straight.hpp"

namespace epura::sheet {

namespace {

constexpr int leader_directions = 24;
constexpr int lengths = 24;
constexpr double shortest_leader_of_circle = 8, longer_leader = 4;  // leaders, mm
constexpr double steep = 0.5;                                       // cosine of its angle to the horizontal

/// A leader from a shoulder with the text to the arrow on the circle; a negative length lies inside the circle.
struct Leader {
  Vec2 direction;
  double length;
  bool turned = false;  ///< whether the shoulder is on the other side, as it may be where the leader is steep
};

PlacedDimension drawn(const Leader& leader, const MeasuredCircle& circle, const DimensionText& text,
                      const DimensionStyle& style) {
  const auto& [direction, length, turned] = leader;
  const Vec2 tip = circle.centre + circle.reach(direction) * direction;
  const Vec2 elbow = tip + length * direction;
  check(circle.radius >= 0, "a circle has a radius");
  const Vec2 outward = length < 0 ? -direction : direction;
  PlacedDimension dimension;
  add_leader(dimension, text, {tip, elbow, (outward.x < 0) != turned}, style);
  dimension.arrows = {arrow_at(tip, -outward, style)};
  // Files have no diameters and radii of ellipses.
  if (circle.is_label || circle.spokes) return dimension;
  DimensionObject& object = dimension.objects.emplace_back(
      DimensionObject{circle.is_radius ? DimensionShape::radius : DimensionShape::diameter, {circle.centre, tip}});
  if (!circle.is_radius) object.points[0] = circle.centre - circle.radius * direction;
  object.leader = std::abs(length);
  object.value = circle.value;
  return dimension;
}

// The others outlive the placements.
std::function<PlacedDimension()> drawn_when_looked_at(const Leader& leader, const MeasuredCircle& circle,
                                                      const DimensionText& text, const DimensionStyle& style) {
  return [=, &circle, &text, &style] { return drawn(leader, circle, text, style); };
}

double slope_cost(double angle) {
  const double off = std::abs(std::remainder(angle - std::numbers::pi / 4, std::numbers::pi / 2));
  return cost_of_slope * off / (std::numbers::pi / 4);
}

// A dimension line across the whole circle, from arrow to arrow.
void add_across(std::vector<ItemPlacement>& placements, const MeasuredCircle& circle, const DimensionText& text,
                double angle, const DimensionStyle& style) {
  const Vec2 along = turned_to(angle), spoke = circle.radius * along;
  const MeasuredLength length{circle.centre - spoke, circle.centre + spoke, along, left_of(along)};
  if (!fits_inside(length, text, style)) return;
  for (int place = 0; place < text_places; ++place) {
    PlacedDimension dimension = straight_dimension(length, text, 0, place, style);
    DimensionObject object{DimensionShape::diameter, {length.to, length.from}};
    object.value = circle.value;
    dimension.objects = {std::move(object)};
    placements.push_back({std::move(dimension), cost_of_crossing_it + slope_cost(angle) + 0.1 * place});
  }
}

// A text beside the circle, without a leader while it is near.
void add_labels(std::vector<ItemPlacement>& placements, const MeasuredCircle& circle, const DimensionText& text,
                const DimensionStyle& style) {
  constexpr int sides = 8, distances = 4;
  constexpr double nearest = 0.3, farther = 0.5;  // of the height of capitals
  for (int i = 0; i < sides; ++i)
    for (int k = 0; k < distances; ++k) {
      // From the upper right counterclockwise.
      const Vec2 direction = turned_to((2 * i + 1) * std::numbers::pi / sides);
      const Vec2 tip = circle.centre + (circle.reach(direction) + (nearest + farther * k) * style.text) * direction;
      const Vec2 half(style.width(text) / 2, style.text / 2);
      PlacedDimension dimension;
      set_text(dimension, text, {tip + half * direction, {1, 0}, -style.text / 2}, style);
      dimension.zones = dimension.text_boxes;
      placements.push_back({std::move(dimension), 0.1 * i + k});
    }
}

// The middle of each of `count` parts of an arc; for a circle, the diagonals are included.
std::vector<double> angles_of(const MeasuredCircle& circle, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i)
    angles.push_back(circle.first + (circle.is_whole() ? i : i + 0.5) * circle.sweep / count);
  return angles;
}

}  // namespace

std::vector<ItemPlacement> placements_of(const MeasuredCircle& circle, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  std::vector<ItemPlacement> placements;
  if (circle.is_label) add_labels(placements, circle, measured.text, style);
  const DrawnParts drawn_parts(drawing, circle);
  for (const double angle : drawn_parts.among(angles_of(circle, leader_directions))) {
    const Vec2 direction = turned_to(angle);
    const auto add = [&](double length, double cost) {
      for (const bool turned : {false, true})
        if (!turned || (length > 0 && !measured.offset && std::abs(direction.x) < steep))
          placements.push_back({drawn_when_looked_at({direction, length, turned}, circle, measured.text, style),
                                cost + slope_cost(angle) + (turned ? cost_of_turn : 0)});
    };
    if (measured.offset) {
      add(*measured.offset, 0);
      continue;
    }
    bool from_inside = circle.is_radius;
    for (int k = 0; k < lengths; ++k) {
      const double length = shortest_leader_of_circle + longer_leader * k, past = length - circle.radius;
      add(length, cost_of_length * length + (circle.is_label ? cost_of_label_leader : 0));
      if (!from_inside) continue;
      // Past the centre better over free paper, to which fillets are open.
      const TurnedBox beyond = line_box(circle.centre, circle.centre - std::max(past, 0.0) * direction);
      const double crossed = past > 0 ? cost_of_crossing * ink_in(beyond, drawing) : 0;
      from_inside = crossed < cost_of_other;
      if (from_inside) add(-length, cost_of_inside + cost_of_length * length + crossed);
    }
    if (!circle.is_radius && !circle.is_label && !circle.spokes && circle.is_whole() &&
        drawn_parts.is_at(angle) == drawn_parts.is_at(angle + std::numbers::pi))
      add_across(placements, circle, measured.text, angle, style);
  }
  check(!placements.empty(), "a circle has a place for its text");
  return placements;
}

std::vector<ItemPlacement> placements_in_crowd(const MeasuredCircle& circle, const MeasuredDimension& measured,
                                               const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  constexpr int more_directions = 3, more_lengths = 2;  // times
  check(circle.radius >= 0 && circle.sweep != 0, "an arc has a length");
  std::vector<ItemPlacement> placements;
  if (measured.offset || circle.is_label) return placements;
  for (const double angle : DrawnParts(drawing, circle).among(angles_of(circle, more_directions * leader_directions))) {
    const Vec2 direction = turned_to(angle);
    for (int k = 0; k < more_lengths * lengths; ++k) {
      const double length = shortest_leader_of_circle + longer_leader * k;
      const double cost = cost_of_length * length + slope_cost(angle);
      const auto add = [&](const Leader& leader, double more) {
        placements.push_back({drawn_when_looked_at(leader, circle, measured.text, style), cost + more});
      };
      add({direction, length}, 0);
      if (std::abs(direction.x) < steep) add({direction, length, true}, cost_of_turn);
      // From inside, and past the centre.
      if (circle.is_radius) add({direction, -length}, cost_of_inside);
    }
  }
  return placements;
}

}  // namespace epura::sheet
