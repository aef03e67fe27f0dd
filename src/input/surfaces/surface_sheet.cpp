// SPDX-License-Identifier: Apache-2.0
#include "surfaces/surface_sheet.hpp"

#include <cmath>

namespace epura::surfaces {

namespace {

// The mirror image beyond the apex, if the mean point lies there.
PartSurface on_sheet_of_cone(const PartSurface& cone, std::span<const Vec3> points) {
  double radii = 0;
  for (const Vec3& p : points) radii += cone.radius + cone.slope * profile_of(cone, p).y;
  if (radii >= 0) return cone;
  PartSurface other = cone;
  other.origin -= 2 * cone.radius / cone.slope * cone.axis;
  other.axis = -cone.axis;
  return other;
}

bool are_on_inner_sheet(const PartSurface& torus, std::span<const Vec3> points) {
  double outer = 0, inner = 0;
  for (const Vec3& p : points) {
    const Vec2 place = profile_of(torus, p);
    outer += std::abs(std::hypot(place.x - torus.radius, place.y) - torus.minor);
    inner += std::abs(std::hypot(place.x + torus.radius, place.y) - torus.minor);
  }
  return inner < outer;
}

}  // namespace

bool has_two_sheets(const PartSurface& surface) {
  return (surface.kind == SurfaceKind::cone && surface.slope != 0) ||
         (surface.kind == SurfaceKind::torus && surface.minor > surface.radius);
}

PartSurface on_sheet_of(const PartSurface& surface, std::span<const Vec3> points) {
  if (!has_two_sheets(surface)) return surface;
  if (surface.kind == SurfaceKind::cone) return on_sheet_of_cone(surface, points);
  return are_on_inner_sheet(surface, points) ? PartSurface{} : surface;
}

}  // namespace epura::surfaces
