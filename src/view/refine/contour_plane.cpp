// SPDX-License-Identifier: Apache-2.0
#include "refine/contour_plane.hpp"

#include <array>
#include <cmath>

#include "refine/limits.hpp"

namespace epura::refine {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

/// A number that vanishes on a surface, and how it grows.
struct Condition {
  double value;
  Vec3 slopes;
};

using Conditions = std::array<Condition, 3>;

// Newton's step to where all vanish; nothing if their surfaces nearly touch.
std::optional<Vec3> step_to(const Conditions& all) {
  const Vec3 across = glm::cross(all[1].slopes, all[2].slopes);
  const double volume = glm::dot(all[0].slopes, across);
  if (!(std::abs(volume) >= least_volume)) return std::nullopt;
  return -(all[0].value * across + all[1].value * glm::cross(all[2].slopes, all[0].slopes) +
           all[2].value * glm::cross(all[0].slopes, all[1].slopes)) /
         volume;
}

// Returns the point near a place at which `conditions_at(point)` vanish.
template <class ConditionsAt>
std::optional<Vec3> solve(const Vec3& place, double reach, const ConditionsAt& conditions_at) {
  Vec3 at = place;
  for (int step = 0; step < newton_steps; ++step) {
    const std::optional<Vec3> by = step_to(conditions_at(at));
    if (!by) return std::nullopt;
    at += *by;
    if (!(glm::distance(at, place) <= reach)) return std::nullopt;
    if (glm::length(*by) <= rounding_part * reach) return at;
  }
  return std::nullopt;
}

Condition on(const PartSurface& surface, const Vec3& point) {
  const surfaces::Nearness near = surfaces::nearness_of(surface, point);
  return {near.distance, near.normal};
}

std::optional<Vec3> unit(const Vec3& vector) {
  const double length = glm::length(vector);
  return length >= least_volume ? std::optional(vector / length) : std::nullopt;
}

}  // namespace

Viewer viewer_of(const world::Placed& placed, const projection::Projection& projection) {
  const Mat4 to_file = glm::inverse(placed.to_world);
  const Vec3 place(to_file * Vec4(projection.projector, projection.central ? 1 : 0));
  return {projection.central, projection.central ? place : glm::normalize(place)};
}

std::optional<ContourPlane> contour_plane(const PartSurface& surface, const Viewer& viewer) {
  if (!has_contour_plane(surface.kind)) return std::nullopt;
  const Vec3 to = viewer.central ? viewer.place - surface.origin : viewer.place;
  const double along = glm::dot(to, surface.axis);
  const Vec3 across = to - along * surface.axis;
  // The radius at the height of the viewer, or per length towards it: n . projector is across . p less this times the
  // radius at p, but for a positive factor.
  const double radius = (viewer.central ? surface.radius : 0) + surface.slope * along;
  const Vec3 normal = across - radius * surface.slope * surface.axis;
  const double length = glm::length(normal);
  if (!(length > along_axis * glm::length(to))) return std::nullopt;
  return ContourPlane{normal / length, (glm::dot(normal, surface.origin) + radius * surface.radius) / length};
}

Vec3 place_on_contour(const PartSurface& surface, const ContourPlane& plane, const Vec3& place,
                      const std::optional<Rim>& rim, double reach) {
  const auto solve_with = [&](const auto& third) {
    return solve(place, reach, [&](const Vec3& p) {
      return Conditions{on(surface, p), Condition{plane.height(p), plane.normal}, third(p)};
    });
  };
  const auto in_plane_of = [&](const Vec3& normal) {
    return solve_with([&](const Vec3& p) { return Condition{glm::dot(normal, p - place), normal}; });
  };
  const Vec3 out = surfaces::normal_near(surface, place);
  std::optional<Vec3> found;
  if (rim && rim->beyond != nullptr && rim->beyond->kind == SurfaceKind::plane) {
    const Vec3& axis = rim->beyond->axis;
    if (const auto normal = unit(axis - glm::dot(axis, rim->along) * rim->along)) found = in_plane_of(*normal);
  } else if (rim && rim->beyond != nullptr && rim->beyond->kind != SurfaceKind::free_form) {
    found = solve_with([&](const Vec3& p) { return on(*rim->beyond, p); });
  }
  if (!found)
    if (const auto normal = unit(rim ? glm::cross(rim->along, out) : glm::cross(out, plane.normal)))
      found = in_plane_of(*normal);
  return found.value_or(place);
}

}  // namespace epura::refine
