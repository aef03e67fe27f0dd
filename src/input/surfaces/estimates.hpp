// SPDX-License-Identifier: Apache-2.0
// Surfaces through a few adjacent facets, from which a fit to their vertices can start.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "surfaces/part_surface.hpp"

namespace epura::surfaces {

/// The properties of a facet that a fit uses: a point in its middle and a unit normal.
struct Facing {
  Vec3 middle, normal;
  double weight;
};

std::optional<PartSurface> begin_plane(std::span<const Vec3> points);
std::optional<PartSurface> begin_cylinder(std::span<const Facing> facings, std::span<const Vec3> points);
std::optional<PartSurface> begin_cone(std::span<const Facing> facings, std::span<const Vec3> points);
std::optional<PartSurface> begin_sphere(std::span<const Vec3> points);
/// Normals meet the axis: finds the line that comes nearest to that (Pottmann, Wallner: Computational Line Geometry,
/// 2001). Exact for nets of meridians and parallels.
std::optional<PartSurface> begin_torus_by_normals(std::span<const Facing> facings, std::span<const Vec3> points);

/// The principal curvatures of a surface.
struct Curvatures {
  Vec3 point, normal;
  std::array<double, 2> value;  ///< positive where the surface turns towards the normal
  std::array<Vec3, 2> direction;
};

/// Returns the curvatures in the middle of points, whatever their arrangement.
std::optional<Curvatures> curvatures_of(const Facing& middle, std::span<const Vec3> points);

// Return the best of several surfaces with these curvatures.

std::optional<PartSurface> begin_cone_by_curvatures(const Curvatures& at, std::span<const Vec3> points);
std::optional<PartSurface> begin_torus_by_curvatures(const Curvatures& at, std::span<const Vec3> points);

}  // namespace epura::surfaces
