// SPDX-License-Identifier: Apache-2.0
// The surface along which a section cuts: a plane; several parallel planes joined by steps; or planes that meet in
// axes.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/description.hpp"

namespace epura::cut {

/// A plane that limits a region of a cutting surface; its normal points out of the region.
struct CutBorder {
  Vec3 point;
  Vec3 normal;  ///< unit normal
};

/// The side of a border on which a point lies: 1 outside the region, -1 inside, 0 closer to it than `slack`.
int side_of(const CutBorder& border, const Vec3& point, double slack);

/// A convex prism parallel to the viewing direction, in which one plane cuts, or nothing.
struct CutRegion {
  std::optional<scene::CuttingPlane> plane;  ///< nothing: everything is kept
  std::vector<CutBorder> borders;
  Mat4 turn{1.0};  ///< of what remains in it, into the plane of the view; the identity unless the section is aligned
};

/// The plane of a region where the view shows it.
scene::CuttingPlane turned_plane(const CutRegion& region);

/// Steps between planes are parallel to the viewing direction. They leave no line in the section (ISO 128-3), nor do
/// the axes in which the planes of an aligned section meet. The regions of these are what is perpendicular to their
/// planes; they may overlap, and are beside each other once they are turned.
struct CuttingSurface {
  scene::CuttingPlane plane;       ///< of the first region that has one
  std::vector<CutRegion> regions;  ///< one without borders if the surface is a plane; otherwise they fill space
  Vec3 along{0};                   ///< unit vector perpendicular to the steps and the normal; zero without steps
  std::vector<Vec3> path{};        ///< corners of the trace, ends included; empty without steps
  bool beyond = true;              ///< false: only cut faces remain
  std::vector<Vec3> divides{};     ///< points of steps between a region that is cut and one that is kept whole
  bool aligned = false;  ///< planes that are not parallel, each turned about the axis in which it meets the next

  [[nodiscard]] bool is_plane() const { return regions.size() == 1; }
  /// Of an aligned section: the direction of the axes in which its planes meet; length 1.
  [[nodiscard]] Vec3 axis() const { return glm::normalize(glm::cross(plane.normal, along)); }
};

/// How the view of an aligned section turns what is at a point of the models: with the nearest plane behind which it
/// is. Nothing if the section leaves it out. `slack` is the distance up to which points are on a plane.
std::optional<Mat4> turn_at(const CuttingSurface& surface, const Vec3& point, double slack);

/// Whether a section shows what is at a point of the models: it is not in front of the surface.
bool keeps(const CuttingSurface& surface, const Vec3& point, double slack);

/// A surface of one plane.
CuttingSurface plane_surface(const scene::CuttingPlane& plane);

/// The surface of a section's plane or path. A path is a polyline in a plane parallel to the normal; each of its legs
/// is perpendicular to the normal, a cutting plane, or parallel to it, a step. The first and last plane reach to
/// infinity; next to a path that begins or ends with a step, everything is kept (half sections). In an aligned section,
/// each leg is a cutting plane, and those that are not perpendicular to the normal are turned; but a leg between two
/// others in one direction, to which it is perpendicular, is a step. Throws Error{input}.
CuttingSurface make_cutting_surface(const scene::SectionDescription& section);

}  // namespace epura::cut
