// SPDX-License-Identifier: Apache-2.0
#include "sizes/place_joins.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/joined.hpp"
#include "features/tolerances.hpp"
#include "sizes/cone_angles.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/hexagon_widths.hpp"
#include "sizes/place_chain.hpp"
#include "sizes/slope_dimensions.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::parallel;
using Joins = std::vector<PlaceJoin>;

double middle_of(const features::Extent& extent) { return (extent.from + extent.to) / 2; }

/// A dimension, and what it may speak of.
struct Reading {
  const AnchoredDimension& dimension;
  const DimensionsInView& view;
  const DimensionSubject& subject;
  const FeatureTable& table;
  const Notation& notation;

  [[nodiscard]] const features::Extent& extent(int axis) const {
    return subject.extents[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] bool is_of_many() const { return repeats_of(dimension.text) > 1; }
};

Joins sides_of(int axis, double middle, double radius) {
  return {{axis, middle, middle - radius}, {axis, middle, middle + radius}};
}

// What is symmetrical to the axis of a round part, or to the line of centres of an arm, needs no position.
Joins joins_between(const Reading& of, int axis, double a, double b) {
  Joins joins;
  const double middle = middle_of(of.extent(axis));
  if (of.extent(axis).form != features::ExtentForm::length && agree(b - middle, middle - a))
    joins.push_back({axis, middle, a});
  for (const features::ArmFeature& arm : of.subject.features.arms)
    if (arm.has_sides(axis, a, b)) joins.push_back({axis, arm.centres[0][axis], a});
  if (of.is_of_many() && of.dimension.text.find('=') != std::string::npos)
    joins.push_back({axis, a, b, repeats_of(of.dimension.text)});
  else
    joins.push_back(
        {axis, a, b, 1, length_text(std::abs(b - a), of.notation) + " along " + axis_names[std::size_t(axis)]});
  return joins;
}

// Each place with the first one, or in a chain with the one before.
Joins joins_of_row(const Reading& of, int axis) {
  std::vector<double> places;
  for (const Vec3& point : of.dimension.points) places.push_back(point[axis]);
  const bool is_chain = *of.dimension.arrangement == DimensionArrangement::chain;
  if (is_chain) std::sort(places.begin(), places.end());
  Joins joins;
  for (std::size_t i = 1; i < places.size(); ++i)
    joins = joined(std::move(joins), joins_between(of, axis, places[is_chain ? i - 1 : 0], places[i]));
  return joins;
}

// The width across flats gives the places of flats and corners.
Joins joins_of_hexagons(const Reading& of) {
  Joins joins;
  for (const std::size_t number : hexagons_of(of.dimension, of.view, of.subject)) {
    const features::HexagonFeature& hexagon = of.subject.features.hexagons[number];
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(hexagon.axis[axis]) > parallel) continue;
      const double reach = hexagon.reach(Mat3(1)[axis]);
      check(reach > 0, "a hexagon reaches to either side of its axis");
      joins = joined(std::move(joins), sides_of(axis, hexagon.centre[axis], reach));
    }
  }
  return joins;
}

// The width of a turned part gives, with the other one and their angle, its size along the axes of the world.
Joins joins_of_prisms(const Reading& of) {
  Joins joins;
  for (const TurnedPrism& prism : of.table.prisms) {
    if (!is_width_of(of.dimension, prism, 0) && !is_width_of(of.dimension, prism, 1)) continue;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(prism.axis[axis]) <= parallel)
        joins = joined(std::move(joins), sides_of(axis, prism.centre[axis], prism.reach(Mat3(1)[axis])));
  }
  return joins;
}

// The length of one of several equal slots joins the ends of all of them.
Joins joins_of_slots(const Reading& of, int axis) {
  Joins joins;
  for (const features::SlotFeature& slot : of.subject.features.slots)
    joins.push_back({axis, slot.centres[0][axis], slot.centres[1][axis]});
  return joins;
}

// The note of a chamfer gives its size along both axes; "4×" those of all that are equal to it.
Joins joins_of_chamfers(const Reading& of) {
  const int along = world_axis(of.view.projection.n);
  const std::vector<Vec3>& points = of.dimension.points;
  const double leg = glm::length(points[1] - points[0]) / std::sqrt(2.0);
  Joins joins;
  for (const features::BevelFeature& bevel : of.subject.features.bevels) {
    if (!bevel.is_chamfer || bevel.along != along || !agree(bevel.leg(), leg)) continue;
    const double off = glm::length(bevel.ends[0] + bevel.ends[1] - points[0] - points[1]);
    for (int other = 0; other < 3; ++other)
      if (other != along && (of.is_of_many() || off <= size_agrees * leg))
        joins.push_back({other, bevel.ends[0][other], bevel.ends[1][other]});
  }
  return joins;
}

Joins joins_of_length(const Reading& of) {
  const std::optional<Vec3> along = measured_along(of.dimension, of.view);
  if (!along) return {};
  Joins joins = joined(joins_of_hexagons(of), joins_of_prisms(of));
  const int axis = world_axis(*along);
  if (axis < 0) return joins;
  const std::vector<Vec3>& points = of.dimension.points;
  joins =
      joined(std::move(joins), of.dimension.arrangement ? joins_of_row(of, axis)
                                                        : joins_between(of, axis, points[0][axis], points[1][axis]));
  if (of.dimension.type == DimensionType::aligned && of.is_of_many())
    joins = joined(std::move(joins), joins_of_slots(of, axis));
  if (of.dimension.text.find("×45°") != std::string::npos) joins = joined(std::move(joins), joins_of_chamfers(of));
  return joins;
}

// The axis of a shaft, where flats may have taken one end or, equally, both.
Joins joins_beside_flats(const Reading& of, int axis, const features::Extent& shaft) {
  const double middle = shaft.centre[axis];
  Joins joins = sides_of(axis, middle, shaft.size() / 2);
  const features::Extent& own = of.extent(axis);
  if (agree(own.to - middle, middle - own.from)) joins.push_back({axis, middle, own.from});
  return joins;
}

// A diameter is the size along both axes across a shaft.
Joins joins_of_overall(const Reading& of) {
  const int axis = axis_of(*of.dimension.direction);
  const features::Extent& extent = of.extent(axis);
  Joins joins = joins_of_hexagons(of);
  for (int other = 0; other < 3; ++other) {
    const features::Extent& same = of.extent(other);
    if (other != axis && !extent.is_same_as(same)) continue;
    joins.push_back({other, same.from, same.to, 1,
                     other == axis ? std::string("overall size along ") + axis_names[std::size_t(axis)] : ""});
    if (same.form != features::ExtentForm::length) joins.push_back({other, same.from, middle_of(same)});
  }
  for (int other = 0; other < 3 && extent.form == features::ExtentForm::diameter; ++other)
    if (std::abs(extent.axis[other]) <= parallel)
      joins = joined(std::move(joins), joins_beside_flats(of, other, extent));
  return joins;
}

// A table gives positions from the ends of the models.
Joins joins_of_label(const Reading& of) {
  const WorldCircle& circle = of.dimension.circles.front();
  Joins joins;
  for (int axis = 0; axis < 3; ++axis) {
    const features::Extent& extent = of.extent(axis);
    const bool is_round = extent.form != features::ExtentForm::length;
    if (std::abs(circle.axis[axis]) <= parallel)
      joins.push_back({axis, is_round ? middle_of(extent) : extent.from, circle.centre[axis]});
  }
  return joins;
}

bool lies_on(const Vec3& point, const WorldCircle& circle) {
  return agree(features::distance_from_line(point, circle.centre, circle.axis), circle.radius);
}

// A diameter gives both sides of its circle; "4×" those of all that are equal to it.
Joins joins_of_circles(const Reading& of) {
  Joins joins = of.dimension.is_label ? joins_of_label(of) : Joins{};
  for (const WorldCircle& circle : of.dimension.circles)
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(circle.axis[axis]) > parallel) continue;
      joins = joined(std::move(joins), sides_of(axis, circle.centre[axis], circle.radius));
      for (const FeatureSize& size : of.table.sizes)
        if (of.is_of_many() && size.is_equal(circle))
          joins = joined(std::move(joins), sides_of(axis, size.centre[axis], circle.radius));
      for (const features::HoleFeature& hole : of.subject.features.holes)
        if (lies_on(hole.mouth, circle) && are_parallel(hole.axis, circle.axis))
          joins.push_back({axis, circle.centre[axis], hole.mouth[axis]});
    }
  return joins;
}

// An angle gives the rounded end of a cone.
Joins joins_of_cones(const Reading& of) {
  Joins joins;
  for (const features::ConeFeature& cone : of.subject.features.cones)
    if (const int axis = world_axis(cone.axis);
        axis >= 0 && has_angle(cone, glm::length(of.subject.world.box.size())) && is_angle_of(of.dimension, cone))
      joins.push_back({axis, cone.ends[0][axis], cone.ends[1][axis]});
  return joins;
}

// Or the place of one end of a slope, given the other one.
Joins joins_of_slopes(const Reading& of) {
  Joins joins;
  for (const features::BevelFeature& slope : of.subject.features.bevels)
    if (const auto angled = angled_end(slope, of.subject, of.table, of.notation);
        angled && gives_angle(of.dimension, slope, of.subject.features.bevels))
      joins.push_back({angled->axis, slope.ends[0][angled->axis], slope.ends[1][angled->axis]});
  return joins;
}

}  // namespace

bool is_auxiliary(const AnchoredDimension& dimension) {
  return dimension.text.starts_with('(') || dimension.text.ends_with(" REF");
}

std::optional<Vec3> measured_along(const AnchoredDimension& dimension, const DimensionsInView& view) {
  if (dimension.type != DimensionType::linear && dimension.type != DimensionType::aligned) return std::nullopt;
  Vec3 along = glm::normalize(dimension.points[1] - dimension.points[0]);
  if (dimension.type == DimensionType::linear)
    along = *dimension.direction == DimensionDirection::horizontal ? view.projection.u : view.projection.v;
  if (view.turned_about && !are_parallel(*view.turned_about, along)) return std::nullopt;
  return along;
}

std::vector<std::size_t> hexagons_of(const AnchoredDimension& dimension, const DimensionsInView& view,
                                     const DimensionSubject& subject) {
  const std::vector<features::HexagonFeature>& hexagons = subject.features.hexagons;
  const std::optional<Vec3> along = measured_along(dimension, view);
  const bool is_overall = dimension.type == DimensionType::overall;
  if (is_auxiliary(dimension) || dimension.arrangement || (!along && !is_overall)) return {};
  const auto measures_extent = [&](const features::HexagonFeature& hexagon) {
    check(dimension.direction.has_value(), "an overall size has a direction");
    const int axis = axis_of(*dimension.direction);
    for (int other = 0; other < 3; ++other)
      if ((other == axis || subject.extents[std::size_t(axis)].is_same_as(subject.extents[std::size_t(other)])) &&
          is_extent(hexagon, other, subject, true))
        return true;
    return false;
  };
  const auto measures = [&](const features::HexagonFeature& hexagon) {
    return is_overall ? measures_extent(hexagon)
                      : is_across_flats(hexagon, *along, dimension.points[0], dimension.points[1]);
  };
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < hexagons.size(); ++i) {
    const auto is_equal_to = [&](const features::HexagonFeature& other) {
      return measures(other) && are_equal(other, hexagons[i]);
    };
    const bool many = !is_overall && repeats_of(dimension.text) > 1;
    if (measures(hexagons[i]) || (many && std::any_of(hexagons.begin(), hexagons.end(), is_equal_to)))
      found.push_back(i);
  }
  return found;
}

std::vector<PlaceJoin> joins_of(const AnchoredDimension& dimension, const DimensionsInView& view,
                                const DimensionSubject& subject, const FeatureTable& table, const Notation& notation) {
  const Reading of{dimension, view, subject, table, notation};
  if (is_auxiliary(dimension)) return {};
  switch (dimension.type) {
    case DimensionType::overall:
      return joins_of_overall(of);
    case DimensionType::linear:
    case DimensionType::aligned:
      return joins_of_length(of);
    case DimensionType::diameter:
      return joins_of_circles(of);
    case DimensionType::angular:
      return joined(joins_of_cones(of), joins_of_slopes(of));
    default:
      return {};
  }
}

std::vector<PlaceJoin> joins_of_round_ends(std::span<const double> radii, const DimensionSubject& subject,
                                           const FeatureTable& table) {
  Joins joins;
  for (const RoundEnd& end : joined(table.round_ends, table.channels)) {
    const auto is_it = [&end](double radius) { return agree(radius, end.radius); };
    if (std::none_of(radii.begin(), radii.end(), is_it)) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        const features::Extent& extent = subject.extents[std::size_t(axis)];
        if (end.ends_models(axis, side, extent))
          joins.push_back({axis, end.centre[axis], side == 0 ? extent.from : extent.to});
        else if (end.has_side(axis, side))
          joins.push_back({axis, end.centre[axis], end.at_side(axis, side)});
      }
  }
  return joins;
}

}  // namespace epura::sheet
