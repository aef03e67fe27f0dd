// SPDX-License-Identifier: Apache-2.0
// Where cylinders and cones turn away from the viewer.
//
// Projectors touch a quadric where it meets the polar plane of the centre of projection: for a cylinder or cone, a
// plane through two of its generators. So the height over this plane has the sign of n . projector, with n the normal
// outwards, and it is linear: a triangle with corners on the surface is split where its plane meets the polar plane.
#pragma once

#include <optional>

#include "projection/projection.hpp"
#include "surfaces/part_surface.hpp"
#include "world/world.hpp"

namespace epura::refine {

/// Who looks at a model, in units of its file.
struct Viewer {
  bool central;
  Vec3 place;  ///< central: the centre of projection; parallel: the unit vector towards the viewer

  [[nodiscard]] Vec3 seen_from(const Vec3& point) const { return central ? place - point : place; }
};

Viewer viewer_of(const world::Placed& placed, const projection::Projection& projection);

/// A plane, unit normal . p = offset. In front of it, the viewer sees the outside of the surface, behind it the inside.
struct ContourPlane {
  Vec3 normal;
  double offset;

  [[nodiscard]] double height(const Vec3& point) const { return glm::dot(normal, point) - offset; }
};

constexpr bool has_contour_plane(surfaces::SurfaceKind kind) {
  return kind == surfaces::SurfaceKind::cylinder || kind == surfaces::SurfaceKind::cone;
}

/// Returns the plane in which a cylinder or cone has its contour; nothing for other surfaces, and for a cylinder seen
/// along its axis.
std::optional<ContourPlane> contour_plane(const surfaces::PartSurface& surface, const Viewer& viewer);

/// The side of a face along which its contour ends: what else holds a point there.
struct Rim {
  Vec3 along;                             ///< unit vector along the chord of the rim
  const surfaces::PartSurface* beyond{};  ///< surface of the face beyond it; null if it is not known
};

/// Returns the point of a contour that belongs to a place on a facet and in the plane: on the surface, in the plane,
/// and at a rim on the surface beyond it, of planes in the facets that represent them. Where both surfaces touch, or
/// one is not known, it is moved along the normal alone, and nowhere if that fails within the distance `reach`.
Vec3 place_on_contour(const surfaces::PartSurface& surface, const ContourPlane& plane, const Vec3& place,
                      const std::optional<Rim>& rim, double reach);

}  // namespace epura::refine
