// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/drawn_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "sheet/dimensions/feature_table.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

namespace {

using definition::Part;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

bool is_on(const WorldCircle& circle, const PartSurface& axis, double slack) {
  return features::are_parallel(axis.axis, circle.axis) &&
         std::abs(features::distance_from_line(circle.centre, axis.origin, axis.axis) - circle.radius) <= slack;
}

// Where an axis crosses the plane of a circle, as an angle.
double angle_of(const PartSurface& axis, const WorldCircle& circle) {
  const Vec3 off = axis.origin - circle.centre;
  const auto [u, v] = surfaces::square_to(circle.axis);
  return std::atan2(glm::dot(off, v), glm::dot(off, u));
}

// Whether angles divide the turn evenly; those of one axis count once.
bool are_even(std::vector<double> angles) {
  constexpr double slack = definition::drawn_parallel * 10;
  std::sort(angles.begin(), angles.end());
  std::vector<double> once;
  for (const double angle : angles)
    if (once.empty() || angle - once.back() > slack) once.push_back(angle);
  for (std::size_t i = 0; i < once.size(); ++i) {
    const double next = i + 1 < once.size() ? once[i + 1] : once[0] + full_turn;
    if (std::abs(next - once[i] - full_turn / static_cast<double>(once.size())) > slack) return false;
  }
  return once.size() > 1;
}

void add_pitch_circle(DrawnPart& drawn, const WorldCircle& circle) {
  const double slack = slack_of(drawn.part);
  std::vector<int> axes;
  std::vector<double> angles;
  for (std::size_t i = 0; i < drawn.faces; ++i) {
    const PartSurface& surface = drawn.part.faces[i].surface;
    const bool is_own = features::are_parallel(surface.axis, circle.axis) &&
                        features::distance_from_line(circle.centre, surface.origin, surface.axis) <= slack;
    if (is_own && surfaces::has_axis(surface.kind) && agree(surface.radius, circle.radius)) return;
    if (surface.kind != SurfaceKind::cylinder || !is_on(circle, surface, slack)) continue;
    axes.push_back(static_cast<int>(i));
    angles.push_back(angle_of(surface, circle));
  }
  check(axes.size() == angles.size(), "each axis on a circle has its angle");
  if (axes.size() < 2) return;
  const PartSurface line{
      .kind = SurfaceKind::cylinder, .origin = circle.centre, .axis = circle.axis, .radius = circle.radius};
  drawn.marks.circles.push_back({static_cast<int>(drawn.part.faces.size()), axes, are_even(angles)});
  drawn.part.faces.push_back({line, circle.centre});
}

// Pairs of planes on both sides of the axis of a round part.
void add_symmetry(DrawnPart& drawn, const features::Extent& extent) {
  const double slack = slack_of(drawn.part);
  int axis = -1;
  for (std::size_t i = 0; i < drawn.faces && axis < 0; ++i)
    if (const PartSurface& one = drawn.part.faces[i].surface;
        one.kind == SurfaceKind::cylinder && features::are_parallel(one.axis, extent.axis) &&
        features::distance_from_line(extent.centre, one.origin, one.axis) <= slack)
      axis = static_cast<int>(i);
  if (axis < 0) return;
  for (std::size_t i = 0; i < drawn.faces; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const PartSurface &a = drawn.part.faces[i].surface, &b = drawn.part.faces[j].surface;
      if (a.kind != SurfaceKind::plane || b.kind != SurfaceKind::plane || !features::are_parallel(a.axis, b.axis) ||
          std::abs(glm::dot(a.axis, extent.axis)) > features::parallel)
        continue;
      const double off = glm::dot(a.origin - extent.centre, a.axis), other = glm::dot(b.origin - extent.centre, a.axis);
      if (std::abs(off) <= slack || std::abs(off + other) > slack) continue;
      const PartSurface middle{.kind = SurfaceKind::plane, .origin = extent.centre, .axis = a.axis};
      drawn.marks.symmetries.push_back(
          {static_cast<int>(drawn.part.faces.size()), {{static_cast<int>(i), static_cast<int>(j)}}, {axis}});
      drawn.part.faces.push_back({middle, extent.centre});
    }
  check(drawn.part.faces.size() >= drawn.faces, "the faces of the model come before what is only drawn");
}

}  // namespace

double slack_of(const Part& part) { return definition::drawn_in_line * part.size; }

DrawnPart with_drawn_lines(Part part, std::span<const DimensionsInView> views,
                           std::span<const features::Extent, 3> extents) {
  const std::size_t faces = part.faces.size();
  DrawnPart drawn{std::move(part), faces, {}};
  std::vector<WorldCircle> seen;
  for (const DimensionsInView& view : views)
    for (const AnchoredDimension& dimension : view.dimensions) {
      if (dimension.type != DimensionType::diameter || dimension.circles.empty()) continue;
      const WorldCircle& circle = dimension.circles.front();
      const bool is_new = std::none_of(seen.begin(), seen.end(), [&](const WorldCircle& one) {
        return glm::distance(one.centre, circle.centre) <= slack_of(drawn.part) && agree(one.radius, circle.radius);
      });
      if (is_new) add_pitch_circle(drawn, circle);
      seen.push_back(circle);
    }
  for (std::size_t i = 0; i < 3; ++i)
    if (extents[i].form == features::ExtentForm::diameter &&
        std::none_of(extents.begin(), extents.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const features::Extent& one) { return one.is_same_as(extents[i]); }))
      add_symmetry(drawn, extents[i]);
  check(drawn.part.faces.size() == faces + drawn.marks.circles.size() + drawn.marks.symmetries.size(),
        "each circle and plane of symmetry has a face of its own");
  return drawn;
}

}  // namespace epura::sheet
