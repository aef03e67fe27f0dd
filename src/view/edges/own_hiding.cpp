// SPDX-License-Identifier: Apache-2.0
#include "edges/own_hiding.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "edges/limits.hpp"

namespace epura::edges {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

// Returns the curvature of a torus along the projector through a point, times a positive factor: positive where it
// bends like a ball. By Euler, the curvatures around the tube, 1 / minor, and around the axis, which changes its sign
// at the top of the tube, add up by the squares of the components.
double bend_of_torus(const PartSurface& torus, const Vec3& point, const Vec3& view) {
  const Vec3 from = point - torus.origin, out = from - glm::dot(from, torus.axis) * torus.axis;
  const double away = glm::length(out);
  if (!(away > 0)) return 0;
  const Vec3 normal = surfaces::normal_near(torus, point), around_axis = glm::cross(torus.axis, out) / away;
  const double along_axis = glm::dot(view, around_axis), along_tube = glm::dot(view, glm::cross(normal, around_axis));
  return along_tube * along_tube + along_axis * along_axis * (away - torus.radius) / away;
}

// The same of balls and ring tori; otherwise 0.
double bend_of(const PartSurface& surface, const Vec3& point, const Vec3& view) {
  switch (surface.kind) {
    case SurfaceKind::sphere:
      return 1;
    case SurfaceKind::torus:
      return is_ring_torus(surface) ? bend_of_torus(surface, point, view) : 0;
    default:
      return 0;
  }
}

// Returns how far from a contour its projector meets the torus again, HUGE_VAL if it does not. Along a tangent at o,
// (|q|^2 + R^2 - r^2)^2 - 4 R^2 (|q|^2 - (q a)^2) = 0 for q = o + t v is t^2 (t^2 + 2 b t + c) = 0. Both coefficients
// are taken from the middle between two places: at the end of a contour, c may be 0.
double way_to_torus(const PartSurface& torus, const std::array<Vec3, 2>& ends, const std::array<Vec3, 2>& views) {
  double b = 0, c = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 o = ends[i] - torus.origin;
    const double squares = glm::dot(o, o) + torus.radius * torus.radius - torus.minor * torus.minor;
    const double along = 2 * glm::dot(o, views[i]), rise = glm::dot(torus.axis, views[i]);
    b += along / 2;
    c += (along * along + 2 * squares - 4 * torus.radius * torus.radius * (1 - rise * rise)) / 2;
  }
  if (b * b < c) return HUGE_VAL;
  const double half = std::sqrt(b * b - c);
  if (c < 0) return half - b;  // inside the tube, which the projector leaves
  return b < 0 ? -b - half : HUGE_VAL;
}

}  // namespace

bool is_ring_torus(const PartSurface& surface) {
  return surface.kind == SurfaceKind::torus && surface.minor < surface.radius;
}

void judge_own_hiding(const surfaces::PartFace& face, const std::array<Vec3, 2>& ends, const std::array<Vec3, 2>& views,
                      FeatureEdge& contour) {
  const double outwards = face.inwards ? -1 : 1;
  const double from = outwards * bend_of(face.surface, ends[0], views[0]);
  const double to = outwards * bend_of(face.surface, ends[1], views[1]);
  const bool is_torus = is_ring_torus(face.surface);
  if (!contour.by_chance && std::min(from, to) > -rounding_part && std::max(from, to) > rounding_part)
    // Facets are nearer to this contour than to where the projector meets the surface again.
    contour.clear = is_torus ? static_cast<float>(way_to_torus(face.surface, ends, views) / 2) : HUGE_VALF;
  if (!is_torus || (from >= 0 && to >= 0)) return;
  contour.hollow = 1;
  if (from < 0 && to < 0) return;
  const double cusp = from / (from - to);
  check(cusp >= 0 && cusp <= 1, "a cusp lies between the ends of a contour");
  contour.hollow = static_cast<float>(from < 0 ? cusp : cusp - 1);
}

}  // namespace epura::edges
