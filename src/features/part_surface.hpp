// SPDX-License-Identifier: Apache-2.0
// The surfaces that faces of parts lie on, and their fit to vertices.
//
// Vertices of a tessellated face lie on its surface to the precision of the file, whatever the angles of its facets
// are: so a fit of vertices has residuals thousands of times smaller than the height of an arc over its chord. Fits are
// least squares of true distances (Lukacs, Martin, Marshall: Faithful least-squares fitting of spheres, cylinders,
// cones and tori, ECCV 1998), which begin with what the normals of facets tell.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/vec.hpp"

namespace epura::features {

enum class SurfaceKind : std::uint8_t { plane, cylinder, cone, sphere, torus, free_form };

inline constexpr std::array surface_kind_names{"plane", "cylinder", "cone", "sphere", "torus", "free-form"};

struct PartSurface {
  SurfaceKind kind = SurfaceKind::free_form;
  Vec3 origin{0};     ///< a point of a plane or of an axis; the centre of a sphere or torus
  Vec3 axis{0};       ///< unit: normal of a plane, axis of revolution; zero where there is none
  double radius = 0;  ///< of a cylinder or sphere, of a cone at its origin, of the circle that a torus runs along
  double minor = 0;   ///< radius of the tube of a torus
  double slope = 0;   ///< of a cone: so much its radius grows for a length along its axis
};

/// By what factor a transform multiplies all lengths; nothing where that depends on their direction. Mirrors keep
/// angles, too.
std::optional<double> similarity_scale(const Mat4& transform);

/// Where a transform takes a surface that multiplies all lengths by `scale`.
PartSurface moved(PartSurface surface, const Mat4& transform, double scale);

/// Whether two round surfaces are one and the same, to a millionth of their size. False for planes and free forms.
bool are_one(const PartSurface& one, const PartSurface& other);

/// How many numbers determine a surface.
int unknowns_of(SurfaceKind kind);

/// Positive outside: away from the axis or centre, or on the side of the normal of a plane.
double signed_distance(const PartSurface& surface, const Vec3& point);

/// The unit normal beside a point, outwards as above; zero where there is none.
Vec3 normal_near(const PartSurface& surface, const Vec3& point);

/// Largest distance of the points.
double residual_of(const PartSurface& surface, std::span<const Vec3> points);

/// Makes the sum of squared distances as small as it can be, beginning with the surface as it is. Returns the largest
/// distance; HUGE_VAL where nothing came of it, as of planes, which begin_plane fits. Gives up early where points will
/// hardly come as near as `wanted`.
double refine(PartSurface& surface, std::span<const Vec3> points, double wanted = HUGE_VAL);

/// A facet as a fit sees it: a point in its middle and a unit normal.
struct Facing {
  Vec3 middle, normal;
  double weight;
};

// What to refine, from a few facets beside each other and their vertices.

std::optional<PartSurface> begin_plane(std::span<const Vec3> points);
std::optional<PartSurface> begin_cylinder(std::span<const Facing> facings, std::span<const Vec3> points);
std::optional<PartSurface> begin_cone(std::span<const Facing> facings, std::span<const Vec3> points);
std::optional<PartSurface> begin_sphere(std::span<const Vec3> points);
/// Normals meet the axis: the line nearest to doing so (Pottmann, Wallner: Computational Line Geometry, 2001). Exact
/// for nets of meridians and parallels.
std::optional<PartSurface> begin_torus_by_normals(std::span<const Facing> facings, std::span<const Vec3> points);

/// The principal curvatures of a surface.
struct Curvatures {
  Vec3 point, normal;
  std::array<double, 2> value;  ///< positive where the surface turns towards the normal
  std::array<Vec3, 2> direction;
};

/// In the middle of points, however these lie.
std::optional<Curvatures> curvatures_of(const Facing& middle, std::span<const Vec3> points);

// The best of several that have these curvatures.

std::optional<PartSurface> begin_cone_by_curvatures(const Curvatures& at, std::span<const Vec3> points);
std::optional<PartSurface> begin_torus_by_curvatures(const Curvatures& at, std::span<const Vec3> points);

}  // namespace epura::features
