// SPDX-License-Identifier: Apache-2.0
#include "sizes/round_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/plane_faces.hpp"
#include "features/tolerances.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

constexpr double slack_degrees = 0.5;  // of the ends of an arc, which are vertices of its facets

double degrees_between(const Vec3& a, const Vec3& b) {
  return portable_atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

bool is_half_turn(double half) { return half >= 90 - slack_degrees; }

bool has_hole(const features::PartFeatures& features, const RoundEnd& end) {
  const auto is_around = [&end](const Vec3& point, const Vec3& axis) {
    return features::are_parallel(axis, end.axis) &&
           features::distance_from_line(point, end.centre, end.axis) <= 10 * features::same_size * end.radius;
  };
  return std::any_of(features.holes.begin(), features.holes.end(),
                     [&](const features::HoleFeature& hole) { return is_around(hole.mouth, hole.axis); }) ||
         std::any_of(features.cylinders.begin(), features.cylinders.end(), [&](const features::CylinderFeature& one) {
           return one.inwards && is_around(one.from, one.axis);
         });
}

RoundEnd end_of(const features::ArcFeature& arc, int number) {
  check(arc.points.size() == 9, "an arc has its ends and its middle");
  const Vec3 middle = (arc.points[4] - arc.centre) / arc.radius;
  const double half = degrees_between(middle, (arc.points[0] - arc.centre) / arc.radius);
  return {arc.centre, arc.axis, arc.radius, middle, half, number};
}

bool is_face_of(const surfaces::PartFace& face, const features::ArcFeature& arc) {
  return face.surface.kind == surfaces::SurfaceKind::cylinder && face.inwards == arc.inwards &&
         features::are_same(face.surface.radius, arc.radius) && features::are_parallel(face.surface.axis, arc.axis) &&
         features::distance_from_line(arc.centre, face.surface.origin, face.surface.axis) <=
             10 * features::same_size * arc.radius;
}

// Of each arc, how many faces go on from it tangentially; -1 for one that is no face of a cylinder.
std::vector<int> count_tangents(const DimensionSubject& subject) {
  const std::vector<features::ArcFeature>& arcs = subject.features.arcs;
  std::vector<int> counts(arcs.size(), -1);
  for (std::size_t model = 0; model < subject.world.models.size() && !arcs.empty(); ++model) {
    const world::Placed& placed = subject.world.models[model];
    const auto part = placed.part == nullptr ? std::nullopt : world::place_part(placed);
    if (!part) continue;
    const auto borders = features::borders_of_faces(placed);
    check(borders.size() == part->faces.size(), "each face has its borders");
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const auto face =
          std::ranges::find_if(part->faces, [&](const surfaces::PartFace& one) { return is_face_of(one, arcs[i]); });
      if (arcs[i].model != static_cast<int>(model) || face == part->faces.end()) continue;
      const auto& beside = borders[static_cast<std::size_t>(face - part->faces.begin())];
      counts[i] = static_cast<int>(std::ranges::count_if(beside, &features::FaceBorder::tangent));
    }
  }
  return counts;
}

// The nose of a cam: of a quarter to half a turn, and nothing reaches farther. Rounded corners of a rectangle, which
// turn a quarter, and those beside a face along an axis of the world have a theoretical corner.
bool is_nose(const RoundEnd& end, const DimensionSubject& subject) {
  if (end.half <= 45 + slack_degrees) return false;
  bool is_at_end = false;
  for (const int along : {0, 1, 2})
    for (const int side : {0, 1}) {
      if (end.has_side(along, side)) return false;
      is_at_end = is_at_end || end.ends_models(along, side, subject.extents[static_cast<std::size_t>(along)]);
    }
  return is_at_end;
}

// Whether the size of the models along another axis is its diameter.
bool is_shaft(const features::CylinderFeature& boss, const DimensionSubject& subject) {
  return std::any_of(subject.extents.begin(), subject.extents.end(), [&boss](const features::Extent& extent) {
    return extent.form == features::ExtentForm::diameter && features::are_parallel(extent.axis, boss.axis) &&
           features::distance_from_line(extent.centre, boss.from, boss.axis) <= features::same_size * boss.radius;
  });
}

}  // namespace

bool RoundEnd::bulges(int along, int side) const {
  return degrees_between(middle, (side == 0 ? -1.0 : 1.0) * Mat3(1)[along]) <= half - slack_degrees;
}

bool RoundEnd::has_side(int along, int side) const {
  return is_tangent && std::abs(axis[along]) <= features::parallel && !bulges(along, side) &&
         degrees_between(middle, (side == 0 ? -1.0 : 1.0) * Mat3(1)[along]) <= half + slack_degrees;
}

bool RoundEnd::ends_models(int along, int side, const features::Extent& extent) const {
  check(along >= 0 && along < 3 && (side == 0 || side == 1), "the models have two ends along each axis");
  if (extent.form != features::ExtentForm::length || std::abs(axis[along]) > features::parallel) return false;
  const double way = side == 0 ? -1 : 1, end = side == 0 ? extent.from : extent.to;
  if (std::abs(centre[along] + way * radius - end) > 10 * features::same_size * radius) return false;
  // A rounded corner of the part ends where it touches the faces beside it.
  return bulges(along, side) ||
         (is_half_turn(half) && degrees_between(middle, way * Mat3(1)[along]) <= half + slack_degrees);
}

FlatEnds find_flat_ends(const DimensionSubject& subject) {
  FlatEnds flat{};
  for (const world::Placed& placed : subject.world.models) {
    const auto part = placed.part == nullptr ? std::nullopt : world::place_part(placed);
    if (!part) continue;
    for (const surfaces::PartFace& face : part->faces) {
      const int axis = face.surface.kind == surfaces::SurfaceKind::plane ? features::axis_along(face.surface.axis) : -1;
      if (axis < 0) continue;
      const features::Extent& extent = subject.extents[static_cast<std::size_t>(axis)];
      const double at = face.surface.origin[axis], slack = features::same_size * extent.size();
      if (std::abs(at - extent.from) <= slack) flat[static_cast<std::size_t>(axis)][0] = true;
      if (std::abs(at - extent.to) <= slack) flat[static_cast<std::size_t>(axis)][1] = true;
    }
  }
  return flat;
}

std::vector<RoundEnd> find_round_ends(const DimensionSubject& subject, const FlatEnds& flat) {
  const features::PartFeatures& features = subject.features;
  const std::vector<int> tangents = count_tangents(subject);
  std::vector<RoundEnd> ends;
  for (std::size_t i = 0; i < features.arcs.size(); ++i) {
    if (features.arcs[i].inwards) continue;
    const RoundEnd end = end_of(features.arcs[i], static_cast<int>(i));
    if (is_half_turn(end.half) || has_hole(features, end) || (tangents[i] > 1 && is_nose(end, subject)))
      ends.push_back(end);
  }
  // The drawing of an assembly gives the places of its parts alone.
  if (features.of_assembly) return ends;
  for (const features::CylinderFeature& boss : features.cylinders)
    for (const int along : {0, 1, 2})
      for (const int side : {0, 1}) {
        const features::Extent& extent = subject.extents[static_cast<std::size_t>(along)];
        const auto& own = flat[static_cast<std::size_t>(along)];
        // Of what is round all around, the quarter that looks that way.
        const RoundEnd end{boss.from, boss.axis, boss.radius, (side == 0 ? -1.0 : 1.0) * Mat3(1)[along], 45, -1, false};
        // A shaft with a flat has the distance from it to the side opposite.
        const bool is_flattened = (own[0] || own[1]) && is_shaft(boss, subject);
        if (!boss.inwards && !own[static_cast<std::size_t>(side)] && !is_flattened &&
            end.ends_models(along, side, extent) && end_along(ends, along, side, extent) == nullptr)
          ends.push_back(end);
      }
  check(std::all_of(ends.begin(), ends.end(), [](const RoundEnd& end) { return end.radius > 0; }),
        "a round end has a radius");
  return ends;
}

std::vector<RoundEnd> find_channels(const DimensionSubject& subject) {
  const std::vector<features::ArcFeature>& arcs = subject.features.arcs;
  const std::vector<int> tangents = count_tangents(subject);
  std::vector<RoundEnd> channels;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (!arcs[i].inwards || tangents[i] < 0) continue;
    RoundEnd channel = end_of(arcs[i], static_cast<int>(i));
    channel.is_tangent = tangents[i] > 0;
    if (!channel.is_tangent || is_half_turn(channel.half)) channels.push_back(channel);
  }
  return channels;
}

const RoundEnd* end_along(std::span<const RoundEnd> ends, int axis, int side, const features::Extent& extent) {
  for (const RoundEnd& end : ends)
    if (end.ends_models(axis, side, extent)) return &end;
  return nullptr;
}

}  // namespace epura::sheet
