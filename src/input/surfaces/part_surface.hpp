// SPDX-License-Identifier: Apache-2.0
// The surfaces that faces of parts lie on, and their fit to vertices.
//
// The vertices of a tessellated face lie on its surface to the precision of the file, whatever the angles of its
// facets: so the residuals of a fit to vertices are thousands of times smaller than the height of an arc over its
// chord. Fits are least squares of true distances (Lukacs, Martin, Marshall: Faithful least-squares fitting of spheres,
// cylinders, cones and tori, ECCV 1998), which start from estimates by the normals of facets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/vec.hpp"

namespace epura::surfaces {

enum class SurfaceKind : std::uint8_t { plane, cylinder, cone, sphere, torus, free_form };

inline constexpr std::array surface_kind_names{"plane", "cylinder", "cone", "sphere", "torus", "free-form"};

struct PartSurface {
  SurfaceKind kind = SurfaceKind::free_form;
  Vec3 origin{0};     ///< a point of a plane or of an axis; the centre of a sphere or torus
  Vec3 axis{0};       ///< unit: normal of a plane, axis of revolution; zero if there is none
  double radius = 0;  ///< of a cylinder or sphere, of a cone at its origin, of the circle along which a torus runs
  double minor = 0;   ///< radius of the tube of a torus
  double slope = 0;   ///< of a cone: growth of its radius per length along its axis
};

/// Returns the factor by which a transform multiplies all lengths, or nothing if that depends on their direction.
/// Mirrors preserve angles, too.
std::optional<double> similarity_scale(const Mat4& transform);

/// Returns the image of a surface under a transform that multiplies all lengths by `scale`.
PartSurface moved(PartSurface surface, const Mat4& transform, double scale);

/// Whether two round surfaces are identical, to a millionth of their size. False for planes and free forms.
bool are_one(const PartSurface& one, const PartSurface& other);

/// Whether a surface of this kind turns about an axis that it determines.
inline bool has_axis(SurfaceKind kind) {
  return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::torus;
}

/// Returns how many numbers determine a surface.
int unknowns_of(SurfaceKind kind);

/// Returns the distance, positive outside: away from the axis or centre, or on the side of the normal of a plane.
double signed_distance(const PartSurface& surface, const Vec3& point);

/// Returns a point in a half-plane that begins at the axis: its distance from the axis, and its height along it from
/// the origin.
Vec2 profile_of(const PartSurface& surface, const Vec3& point);

/// Returns the unit normal near a point, outwards as above; zero if there is none.
Vec3 normal_near(const PartSurface& surface, const Vec3& point);

/// A surface near a point, as the two above tell it.
struct Nearness {
  double distance;
  Vec3 normal;
};
Nearness nearness_of(const PartSurface& surface, const Vec3& point);

/// Returns the largest distance of the points from the surface.
double residual_of(const PartSurface& surface, std::span<const Vec3> points);

/// Minimises the sum of squared distances, starting from the given surface. Returns the largest distance; HUGE_VAL if
/// the fit fails, as for planes, which begin_plane fits. Gives up early if the points are unlikely to come as near as
/// `wanted`.
double refine(PartSurface& surface, std::span<const Vec3> points, double wanted = HUGE_VAL);

}  // namespace epura::surfaces
