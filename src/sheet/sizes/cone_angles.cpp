// SPDX-License-Identifier: Apache-2.0
#include "sizes/cone_angles.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "features/tolerances.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;

// The direction on the page in which a view shows a radius of a cone.
Vec3 beside_cone(const features::ConeFeature& cone, const projection::Projection& projection) {
  return are_parallel(projection.u, cone.axis) ? -projection.v : projection.u;
}

bool is_across(const features::ConeFeature& cone, const projection::Projection& projection) {
  return are_parallel(projection.u, cone.axis) || are_parallel(projection.v, cone.axis);
}

// Whether slots have left the rounded edge on both sides of the axis.
bool shows_both_sides(const features::ConeFeature& cone, const features::PartFeatures& features, const Vec3& out) {
  return std::all_of(features.rounds.begin(), features.rounds.end(), [&](const features::RoundFeature& round) {
    const Vec3 apart = round.centre - cone.ends[0];
    const bool is_coaxial = round.model == cone.model && are_parallel(round.axis, cone.axis) &&
                            glm::length(glm::cross(apart, cone.axis)) <= features::same_size * cone.radii[1];
    return !is_coaxial || (round.reaches(out) && round.reaches(-out));
  });
}

}  // namespace

bool has_angle(const features::ConeFeature& cone, double size) {
  return cone.rounded[0] != cone.rounded[1] && glm::distance(cone.apex(), cone.ends[1]) <= size;
}

bool is_angle_of(const AnchoredDimension& dimension, const features::ConeFeature& cone) {
  if (dimension.type != DimensionType::angular) return false;
  check(dimension.points.size() == 3, "an angle has a corner and two legs");
  const Vec3 apex = cone.apex(), towards = glm::normalize(cone.ends[1] - apex);
  const double slack = features::same_size * cone.radii[1];
  if (glm::distance(dimension.points[0], apex) > slack) return false;
  std::array<Vec3, 2> legs{};
  for (const std::size_t i : {0U, 1U}) {
    legs[i] = glm::normalize(dimension.points[i + 1] - apex);
    const double along = glm::dot(legs[i], towards), out = glm::length(glm::cross(legs[i], towards));
    const double off = out * glm::distance(cone.ends[1], apex) - along * cone.radii[1];
    if (std::abs(off) > slack) return false;
  }
  return are_parallel(glm::normalize(legs[0] + legs[1]), cone.axis);
}

const NamedProjection* view_of_angle(const features::ConeFeature& cone, const features::PartFeatures& features,
                                     const ViewChoice& views) {
  const NamedProjection* first = nullptr;
  for (const NamedProjection* view : views.all()) {
    if (!is_across(cone, view->projection)) continue;
    if (shows_both_sides(cone, features, beside_cone(cone, view->projection))) return view;
    if (first == nullptr) first = view;
  }
  return first != nullptr ? first : views.across(cone.axis, cone.ends[0]);
}

std::array<Vec3, 3> anchors_of_angle(const features::ConeFeature& cone, const projection::Projection& across) {
  check(is_across(cone, across), "the axis of a cone is upright or level where its angle is measured");
  const Vec3 out = cone.radii[1] * beside_cone(cone, across);
  return {cone.apex(), cone.ends[1] + out, cone.ends[1] - out};
}

}  // namespace epura::sheet
