// SPDX-License-Identifier: Apache-2.0
// The surface along which a section cuts: a plane, or several parallel planes joined by steps.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/description.hpp"

namespace epura::scene {

/// A plane that limits a region of a cutting surface; its normal points out of the region.
struct CutBorder {
  Vec3 point;
  Vec3 normal;  ///< unit normal
};

/// The side of a border on which a point lies: 1 outside the region, -1 inside, 0 closer to it than `slack`.
int side_of(const CutBorder& border, const Vec3& point, double slack);

/// A convex prism parallel to the viewing direction, in which one plane cuts, or nothing.
struct CutRegion {
  std::optional<CuttingPlane> plane;  ///< nothing: everything is kept
  std::vector<CutBorder> borders;
};

/// Steps between planes are parallel to the viewing direction. They leave no line in the section (ISO 128-3).
struct CuttingSurface {
  CuttingPlane plane;              ///< of the first region that has one
  std::vector<CutRegion> regions;  ///< one without borders if the surface is a plane; otherwise they fill space
  Vec3 along{0};                   ///< unit vector perpendicular to the steps and the normal; zero without steps
  std::vector<Vec3> path{};        ///< corners of the trace, ends included; empty without steps
  bool beyond = true;              ///< false: only cut faces remain
  std::vector<Vec3> divides{};     ///< points of steps between a region that is cut and one that is kept whole

  [[nodiscard]] bool is_plane() const { return regions.size() == 1; }
};

/// A surface of one plane.
CuttingSurface plane_surface(const CuttingPlane& plane);

/// The surface of a section's plane or path. A path is a polyline in a plane parallel to the normal; each of its legs
/// is perpendicular to the normal, a cutting plane, or parallel to it, a step. The first and last plane reach to
/// infinity; next to a path that begins or ends with a step, everything is kept (half sections). Throws Error{input}.
CuttingSurface make_cutting_surface(const SectionDescription& section);

}  // namespace epura::scene
