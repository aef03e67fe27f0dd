// SPDX-License-Identifier: Apache-2.0
#include "surfaces/part_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "surfaces/least_squares.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

// The number of unknowns of a torus, the largest.
using Unknowns = std::array<double, 7>;

/// A point relative to the axis of a surface.
struct Polar {
  double height;  ///< along the axis, from the origin
  double radius;  ///< from the axis
  Vec3 outwards;  ///< unit, from the axis to the point; zero on it
};

inline Polar polar_of(const PartSurface& surface, const Vec3& point) {
  const Vec3 from = point - surface.origin;
  const double height = glm::dot(from, surface.axis);
  const Vec3 across = from - height * surface.axis;
  const double radius = glm::length(across);
  // At an apex, which is on the axis, rounding would choose a direction.
  return {height, radius, radius > 1e-7 * surface.radius ? across / radius : Vec3(0)};
}

// Cosine of the angle between the axis of a cone and its generators.
double cosine_of(const PartSurface& cone) { return 1 / std::sqrt(1 + cone.slope * cone.slope); }

/// The surface near a point.
struct Beside {
  Polar polar;
  Vec3 normal;
  double distance;
};

Beside beside(const PartSurface& s, const Vec3& point) {
  if (s.kind == SurfaceKind::sphere) {
    const Vec3 from = point - s.origin;
    const double length = glm::length(from);
    return {{}, length > 0 ? from / length : Vec3(0), length - s.radius};
  }
  const Polar polar = polar_of(s, point);
  if (s.kind == SurfaceKind::cone) {
    const double c = cosine_of(s);
    return {polar, c * (polar.outwards - s.slope * s.axis), (polar.radius - s.radius - polar.height * s.slope) * c};
  }
  if (s.kind == SurfaceKind::torus) {
    const Vec3 from = (polar.radius - s.radius) * polar.outwards + polar.height * s.axis;
    // Not the length of `from`: on the axis, that has no outward direction.
    const double in = polar.radius - s.radius;
    const double length = std::sqrt(in * in + polar.height * polar.height);
    return {polar, length > 0 ? from / length : Vec3(0), length - s.minor};
  }
  return {polar, polar.outwards, polar.radius - s.radius};
}

/// The ways in which a surface may change: it moves as a whole, turns about the middle of the points, and grows or
/// shrinks so that it stays in place there. Otherwise radii and shifts are hard to separate if the points cover a small
/// part of the surface.
struct Motion {
  Vec3 middle;                 ///< of the points
  std::array<Vec3, 2> across;  ///< perpendicular to the axis
  Vec3 radial;                 ///< from the axis or centre to the middle
  Vec3 normal;                 ///< of the surface near the middle
};

Motion motion_of(const PartSurface& s, const Vec3& middle) {
  const bool turns = s.kind != SurfaceKind::sphere;
  const Vec3 radial = turns ? polar_of(s, middle).outwards : normal_near(s, middle);
  return {middle, square_to(turns ? s.axis : Vec3(0, 0, 1)), radial, normal_near(s, middle)};
}

/// Derivatives of a point's distance with respect to each change, in the order in which `moved` takes them.
Unknowns slopes_at(const PartSurface& s, const Vec3& point, const Beside& there, const Motion& motion) {
  const Vec3& n = there.normal;
  if (s.kind == SurfaceKind::sphere) return {-n.x, -n.y, -n.z, glm::dot(n, motion.radial) - 1};
  const Vec3 turning = glm::cross(n, point - motion.middle);
  const double one = glm::dot(turning, motion.across[0]), two = glm::dot(turning, motion.across[1]);
  if (s.kind == SurfaceKind::torus)
    return {
        -n.x, -n.y, -n.z, one, two, glm::dot(n, motion.radial - there.polar.outwards), glm::dot(n, motion.normal) - 1};
  const double in = -glm::dot(n, motion.across[0]), aside = -glm::dot(n, motion.across[1]);
  if (s.kind == SurfaceKind::cylinder) return {in, aside, one, two, glm::dot(n, motion.radial) - 1};
  const double c = cosine_of(s);
  const double opening = -((there.polar.radius - s.radius) * s.slope + there.polar.height) * c * c * c;
  return {in, aside, one, two, glm::dot(n, motion.radial) - c, opening};
}

// Cayley's formula for the rotation by a small vector.
Vec3 turned(const Vec3& v, const Vec3& by) {
  const Vec3 half = by / 2.0, once = glm::cross(half, v);
  return v + 2 / (1 + glm::dot(half, half)) * (once + glm::cross(half, once));
}

PartSurface moved(PartSurface s, const Unknowns& by, const Motion& motion) {
  // Growth goes along directions that have turned with the surface.
  Vec3 radial = motion.radial, normal = motion.normal;
  const auto turn = [&](double one, double two) {
    const Vec3 rotation = one * motion.across[0] + two * motion.across[1];
    s.axis = glm::normalize(turned(s.axis, rotation));
    s.origin = motion.middle + turned(s.origin - motion.middle, rotation);
    radial = turned(radial, rotation);
    normal = turned(normal, rotation);
  };
  switch (s.kind) {
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
      turn(by[2], by[3]);
      s.origin += by[0] * motion.across[0] + by[1] * motion.across[1] - by[4] * radial;
      s.radius += by[4];
      if (s.kind == SurfaceKind::cone) s.slope += by[5];
      break;
    case SurfaceKind::sphere:
      s.origin += Vec3(by[0], by[1], by[2]) - by[3] * radial;
      s.radius += by[3];
      break;
    case SurfaceKind::torus:
      turn(by[3], by[4]);
      s.origin += Vec3(by[0], by[1], by[2]) - by[5] * radial - by[6] * normal;
      s.radius += by[5];
      s.minor += by[6];
      break;
    case SurfaceKind::plane:
    case SurfaceKind::free_form:
      break;
  }
  return s;
}

/// A surface and its relation to points.
struct Fit {
  PartSurface surface;
  std::vector<Beside> there;
  double sum = 0;  ///< of squared distances

  void look(std::span<const Vec3> points) {
    there.clear();
    there.reserve(points.size());
    sum = 0;
    for (const Vec3& p : points) {
      there.push_back(beside(surface, p));
      sum += there.back().distance * there.back().distance;
    }
  }
};

template <int size>
std::optional<Unknowns> next_move(const Fit& fit, std::span<const Vec3> points, const Motion& motion, double damping) {
  NormalEquations<size> equations;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Unknowns slopes = slopes_at(fit.surface, points[i], fit.there[i], motion);
    std::array<double, size> used;
    std::copy_n(slopes.begin(), size, used.begin());
    equations.add(used, -fit.there[i].distance);
  }
  const auto found = equations.solve(damping);
  if (!found) return std::nullopt;
  Unknowns by{};
  std::copy(found->begin(), found->end(), by.begin());
  return by;
}

std::optional<Unknowns> next_move(const Fit& fit, std::span<const Vec3> points, const Motion& motion, double damping) {
  switch (fit.surface.kind) {
    case SurfaceKind::cylinder:
      return next_move<5>(fit, points, motion, damping);
    case SurfaceKind::cone:
      return next_move<6>(fit, points, motion, damping);
    case SurfaceKind::sphere:
      return next_move<4>(fit, points, motion, damping);
    case SurfaceKind::torus:
      return next_move<7>(fit, points, motion, damping);
    case SurfaceKind::plane:
    case SurfaceKind::free_form:
      break;
  }
  return std::nullopt;
}

// A fit that has a negative radius, or whose slope approaches a right angle, has diverged.
bool is_sound(const PartSurface& s) {
  return finite(s.origin) && finite(s.axis) && s.radius > 0 && (s.kind != SurfaceKind::torus || s.minor > 0) &&
         std::abs(s.slope) < 50;
}

}  // namespace

std::optional<double> similarity_scale(const Mat4& transform) {
  const Mat3 turn(transform);
  const Mat3 product = glm::transpose(turn) * turn;
  const double square = product[0][0];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!(std::abs(product[i][j] - (i == j ? square : 0)) <= min_stretch * square)) return std::nullopt;
  const double scale = std::sqrt(square);
  return scale > 0 ? std::optional(scale) : std::nullopt;
}

PartSurface moved(PartSurface surface, const Mat4& transform, double scale) {
  surface.origin = Vec3(transform * Vec4(surface.origin, 1));
  surface.axis = Mat3(transform) * surface.axis / scale;
  surface.radius *= scale;
  surface.minor *= scale;
  return surface;
}

bool are_one(const PartSurface& one, const PartSurface& other) {
  if (one.kind != other.kind || one.kind == SurfaceKind::free_form || one.kind == SurfaceKind::plane) return false;
  const double slack = same_surface * std::max(one.radius + one.minor, other.radius + other.minor);
  const auto is_near = [&](double length) { return std::abs(length) <= slack; };
  const Vec3 way = other.origin - one.origin;
  if (one.kind == SurfaceKind::sphere) return is_near(glm::length(way)) && is_near(one.radius - other.radius);
  const double height = glm::dot(way, one.axis), along = glm::dot(one.axis, other.axis);
  if (glm::length(glm::cross(one.axis, other.axis)) > same_surface) return false;
  if (!is_near(glm::length(way - height * one.axis))) return false;
  if (one.kind == SurfaceKind::torus)
    return is_near(height) && is_near(one.radius - other.radius) && is_near(one.minor - other.minor);
  const double slope = along < 0 ? -other.slope : other.slope;  // cylinders have slope 0
  return std::abs(one.slope - slope) <= same_surface && is_near(one.radius + one.slope * height - other.radius);
}

int unknowns_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return 3;
    case SurfaceKind::cylinder:
      return 5;
    case SurfaceKind::cone:
      return 6;
    case SurfaceKind::sphere:
      return 4;
    case SurfaceKind::torus:
      return 7;
    case SurfaceKind::free_form:
      break;
  }
  return 0;
}

double signed_distance(const PartSurface& s, const Vec3& point) {
  switch (s.kind) {
    case SurfaceKind::plane:
      return glm::dot(point - s.origin, s.axis);
    case SurfaceKind::sphere:
      return glm::distance(point, s.origin) - s.radius;
    case SurfaceKind::free_form:
      return 0;
    default:
      return beside(s, point).distance;
  }
}

Vec2 profile_of(const PartSurface& surface, const Vec3& point) {
  const Polar polar = polar_of(surface, point);
  return {polar.radius, polar.height};
}

Vec3 normal_near(const PartSurface& s, const Vec3& point) { return nearness_of(s, point).normal; }

Nearness nearness_of(const PartSurface& s, const Vec3& point) {
  if (s.kind == SurfaceKind::plane) return {signed_distance(s, point), s.axis};
  if (s.kind == SurfaceKind::free_form) return {0, Vec3(0)};
  const Beside there = beside(s, point);
  // There is no normal at an apex.
  const bool is_at_apex = s.kind == SurfaceKind::cone && there.polar.outwards == Vec3(0);
  return {there.distance, is_at_apex ? Vec3(0) : there.normal};
}

double residual_of(const PartSurface& surface, std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, std::abs(signed_distance(surface, p)));
  return largest;
}

double refine(PartSurface& surface, std::span<const Vec3> points, double wanted) {
  constexpr int max_steps = 16;
  const auto count = static_cast<double>(points.size());
  const Vec3 middle = mean_of(points);
  // Moves the origin beside the points, so that tilts and shifts of the axis can be told apart.
  const auto recentre = [&] {
    if (surface.kind != SurfaceKind::cylinder && surface.kind != SurfaceKind::cone) return;
    const double along = glm::dot(middle - surface.origin, surface.axis);
    surface.origin += along * surface.axis;
    surface.radius += along * surface.slope;
  };
  recentre();
  if (!is_sound(surface)) return HUGE_VAL;
  Fit fit{surface, {}}, next, beyond;
  fit.look(points);
  const double rounding = 4e-16 * (surface.radius + surface.minor + glm::distance(surface.origin, middle));
  double damping = 1e-8;
  const auto take_step = [&](const Fit& from, Fit& to) {
    const Motion motion = motion_of(from.surface, middle);
    const auto by = next_move(from, points, motion, damping);
    if (!by) return false;
    to.surface = moved(from.surface, *by, motion);
    to.sum = HUGE_VAL;
    if (is_sound(to.surface)) to.look(points);
    return true;
  };
  for (int step = 0; step < max_steps && fit.sum > count * rounding * rounding; ++step) {
    if (!take_step(fit, next)) break;
    // Cones that differ little near the points form a narrow, bent valley: a whole step along it leaves it, and the one
    // after that leads back into it. Tori have one more number, and would fit any small patch.
    const bool is_beside =
        fit.surface.kind == SurfaceKind::cone && damping < whole_step && next.sum >= fit.sum && next.sum < HUGE_VAL;
    if (is_beside && take_step(next, beyond)) std::swap(next, beyond);
    if (!(next.sum < fit.sum)) {
      damping *= 16;
      if (damping > 1e4) break;
      continue;
    }
    // Convergence is quadratic near a surface on which the points lie.
    const bool hopeless = step >= 1 && next.sum > 0.3 * fit.sum && next.sum > count * wanted * wanted;
    const bool done = hopeless || next.sum > 0.999 * fit.sum;
    std::swap(fit, next);
    damping *= 0.02;
    if (done) break;
  }
  surface = fit.surface;
  recentre();
  double largest = 0;
  for (const Beside& there : fit.there) largest = std::max(largest, std::abs(there.distance));
  return is_sound(surface) && std::isfinite(largest) ? largest : HUGE_VAL;
}

}  // namespace epura::surfaces
