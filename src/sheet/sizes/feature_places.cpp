// SPDX-License-Identifier: Apache-2.0
#include "sizes/feature_places.hpp"

#include <cmath>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/placed_balls.hpp"
#include "sizes/slope_dimensions.hpp"

namespace epura::sheet {

namespace {

// Across an axis.
std::vector<FeaturePlace> places_across(const Vec3& centre, const Vec3& axis, const std::string& name) {
  std::vector<FeaturePlace> places;
  for (int other = 0; other < 3; ++other)
    if (std::abs(axis[other]) <= features::parallel) places.push_back({other, centre[other], name});
  return places;
}

std::vector<FeaturePlace> places_of_axes(const DimensionSubject& subject, const FeatureTable& table,
                                         const Notation& notation) {
  const features::PartFeatures& features = subject.features;
  std::vector<FeaturePlace> places;
  for (const PlacedAxis& one : placed_axes(features, table, notation))
    if (!table.is_turned(one.axis))
      for (FeaturePlace& place : places_across(one.centre, one.axis, one.name)) places.push_back(std::move(place));
  for (const int number : table.balls)
    for (int axis = 0; axis < 3; ++axis)
      if (const features::BallFeature& ball = features.balls[static_cast<std::size_t>(number)];
          !ends_models(ball, axis, subject.extents[static_cast<std::size_t>(axis)]))
        places.push_back({axis, ball.centre[axis], "sphere SR" + length_text(ball.radius, notation)});
  for (const FeatureSize& ring : table.of_kind(SizeKind::ring))
    for (int axis = 0; axis < 3; ++axis) places.push_back({axis, ring.centre[axis], ring.name});
  return places;
}

std::vector<FeaturePlace> places_of_ends(const DimensionSubject& subject) {
  const features::PartFeatures& features = subject.features;
  std::vector<FeaturePlace> places;
  for (const features::LevelFeature& level : features.levels) {
    check(level.axis >= 0 && level.axis < 3, "a step is perpendicular to an axis of the world");
    places.push_back({level.axis, level.at, "step"});
    if (level.other_side) places.push_back({level.axis, *level.other_side, ""});
  }
  for (const features::ConeFeature& cone : features.cones)
    if (const int axis = world_axis(cone.axis); axis >= 0)
      for (const Vec3& end : cone.ends) places.push_back({axis, end[axis], "end of a cone"});
  for (const features::BevelFeature& bevel : features.bevels)
    for (int axis = 0; axis < 3; ++axis)
      for (const Vec3& end : bevel.ends)
        if (axis != bevel.along && !has_angle(bevel, subject))
          places.push_back({axis, end[axis], bevel.is_chamfer ? "chamfer" : "slope"});
  for (const features::CylinderFeature& cylinder : features.cylinders)
    if (const int axis = world_axis(cylinder.axis); axis >= 0 && cylinder.thread && cylinder.thread->length)
      places.push_back({axis, cylinder.thread->end[axis], "end of thread " + cylinder.thread->text});
  return places;
}

}  // namespace

std::vector<PlacedAxis> placed_axes(const features::PartFeatures& features, const FeatureTable& table,
                                    const Notation& notation) {
  std::vector<PlacedAxis> axes;
  const auto add = [&](const Vec3& centre, const Vec3& axis, const std::string& name) {
    axes.push_back({centre, axis, name});
  };
  const auto length = [&](double value) { return length_text(value, notation); };
  for (const features::HoleFeature& hole : features.holes) add(hole.mouth, hole.axis, "hole ⌀" + length(hole.diameter));
  for (const features::CylinderFeature& cylinder : features.cylinders)
    add(cylinder.from, cylinder.axis, name_of(cylinder, notation));
  for (const features::SlotFeature& slot : features.slots)
    for (const Vec3& centre : slot.centres) add(centre, slot.axis, "slot R" + length(slot.radius));
  for (const features::PitchCircleFeature& circle : features.pitch_circles)
    add(circle.centre, circle.axis, "pitch circle ⌀" + length(2 * circle.radius));
  for (const RoundEnd& end : table.round_ends) add(end.centre, end.axis, "round end R" + length(end.radius));
  for (const RoundEnd& channel : table.channels) {
    check(channel.radius > 0, "a channel is an arc");
    add(channel.centre, channel.axis, "channel R" + length(channel.radius));
  }
  for (const TurnedPrism& prism : table.prisms)
    if (!table.turned || !is_ended_by(*table.turned, prism))
      add(prism.centre, prism.axis, prism.inwards ? "turned hole" : "turned boss");
  for (const features::ConeFeature& cone : features.cones)
    add(cone.ends[1], cone.axis, "cone ⌀" + length(2 * cone.radii[1]));
  for (const features::HexagonFeature& hexagon : features.hexagons)
    add(hexagon.centre, hexagon.axis, "hexagon " + length(hexagon.across_flats));
  return axes;
}

std::vector<FeaturePlace> places_of_features(const DimensionSubject& subject, const FeatureTable& table,
                                             const Notation& notation) {
  std::vector<FeaturePlace> places = places_of_axes(subject, table, notation);
  for (FeaturePlace& place : places_of_ends(subject)) places.push_back(std::move(place));
  return places;
}

}  // namespace epura::sheet
