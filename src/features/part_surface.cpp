// SPDX-License-Identifier: Apache-2.0
#include "features/part_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/circle_fit.hpp"
#include "base/portable_math.hpp"
#include "features/least_squares.hpp"

namespace epura::features {

namespace {

// Surfaces of a model that is stretched by less are kept.
constexpr double least_stretch = 1e-9;

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
  const auto turn = [&](double one, double two) {
    const Vec3 rotation = one * motion.across[0] + two * motion.across[1];
    s.axis = glm::normalize(turned(s.axis, rotation));
    s.origin = motion.middle + turned(s.origin - motion.middle, rotation);
  };
  switch (s.kind) {
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
      turn(by[2], by[3]);
      s.origin += by[0] * motion.across[0] + by[1] * motion.across[1] - by[4] * motion.radial;
      s.radius += by[4];
      if (s.kind == SurfaceKind::cone) s.slope += by[5];
      break;
    case SurfaceKind::sphere:
      s.origin += Vec3(by[0], by[1], by[2]) - by[3] * motion.radial;
      s.radius += by[3];
      break;
    case SurfaceKind::torus:
      turn(by[3], by[4]);
      s.origin += Vec3(by[0], by[1], by[2]) - by[5] * motion.radial - by[6] * motion.normal;
      s.radius += by[5];
      s.minor += by[6];
      break;
    case SurfaceKind::plane:
    case SurfaceKind::free_form:
      break;
  }
  return s;
}

// Sum of squared distances; some larger number if it exceeds `most`.
double sum_of_squares(const PartSurface& surface, std::span<const Vec3> points, double most) {
  double sum = 0;
  for (const Vec3& p : points) {
    const double d = signed_distance(surface, p);
    sum += d * d;
    if (sum > most) break;
  }
  return sum;
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

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum(0);
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// The point nearest to the lines through the middles of facets along their normals, seen along an axis: the normals of
// a surface of revolution meet its axis.
std::optional<Vec3> meeting_of_normals(std::span<const Facing> facings, const Vec3& axis) {
  NormalEquations<2> equations;
  const auto across = square_to(axis);
  const Vec3 from = facings.front().middle;
  for (const Facing& f : facings) {
    const Vec2 n(glm::dot(f.normal, across[0]), glm::dot(f.normal, across[1]));
    const Vec2 m(glm::dot(f.middle - from, across[0]), glm::dot(f.middle - from, across[1]));
    equations.add({-n.y, n.x}, cross(n, m));
  }
  const auto meeting = equations.solve(0);
  if (!meeting) return std::nullopt;
  return from + (*meeting)[0] * across[0] + (*meeting)[1] * across[1];
}

// A torus that touches the surface and has its curvatures, with the meridian along direction `m`; `turn` holds cosine
// and sine of the angle from the outermost circle of the tube.
std::optional<PartSurface> torus_of(const Curvatures& at, int m, const Vec2& turn) {
  const double along = at.value[m], around = at.value[1 - m];
  if (!(std::abs(along) > 1e-9)) return std::nullopt;
  // The outward direction of the tube points away from where the meridian turns to.
  const Vec3 outwards = along > 0 ? -at.normal : at.normal;
  const auto [c, s] = std::pair(turn.x, turn.y);
  const double around_outwards = along > 0 ? around : -around;
  const double from_axis = std::abs(around_outwards) > 1e-9 ? c / around_outwards : 0;
  const double minor = 1 / std::abs(along);
  const double radius = from_axis - minor * c;
  if (!(from_axis > 0) || !(radius > 0.05 * minor) || radius > 1e3 * minor) return std::nullopt;
  const Vec3 radial = c * outwards - s * at.direction[m];
  const Vec3 axis = s * outwards + c * at.direction[m];
  return PartSurface{SurfaceKind::torus, at.point - minor * outwards - radius * radial, axis, radius, minor};
}

}  // namespace

std::optional<double> similarity_scale(const Mat4& transform) {
  const Mat3 turn(transform);
  const Mat3 product = glm::transpose(turn) * turn;
  const double square = product[0][0];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!(std::abs(product[i][j] - (i == j ? square : 0)) <= least_stretch * square)) return std::nullopt;
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
  constexpr double part_of_size = 1e-6;
  if (one.kind != other.kind || one.kind == SurfaceKind::free_form || one.kind == SurfaceKind::plane) return false;
  const double slack = part_of_size * std::max(one.radius + one.minor, other.radius + other.minor);
  const auto is_near = [&](double length) { return std::abs(length) <= slack; };
  const Vec3 way = other.origin - one.origin;
  if (one.kind == SurfaceKind::sphere) return is_near(glm::length(way)) && is_near(one.radius - other.radius);
  const double height = glm::dot(way, one.axis), along = glm::dot(one.axis, other.axis);
  if (glm::length(glm::cross(one.axis, other.axis)) > part_of_size) return false;
  if (!is_near(glm::length(way - height * one.axis))) return false;
  if (one.kind == SurfaceKind::torus)
    return is_near(height) && is_near(one.radius - other.radius) && is_near(one.minor - other.minor);
  const double slope = along < 0 ? -other.slope : other.slope;  // cylinders have slope 0
  return std::abs(one.slope - slope) <= part_of_size && is_near(one.radius + one.slope * height - other.radius);
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

Vec3 normal_near(const PartSurface& s, const Vec3& point) {
  if (s.kind == SurfaceKind::plane) return s.axis;
  if (s.kind == SurfaceKind::free_form) return Vec3(0);
  const Beside there = beside(s, point);
  // There is no normal at an apex.
  return s.kind == SurfaceKind::cone && there.polar.outwards == Vec3(0) ? Vec3(0) : there.normal;
}

double residual_of(const PartSurface& surface, std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, std::abs(signed_distance(surface, p)));
  return largest;
}

double refine(PartSurface& surface, std::span<const Vec3> points, double wanted) {
  constexpr int most_steps = 16;
  constexpr double whole_step = 1e-3;  // damping
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
  for (int step = 0; step < most_steps && fit.sum > count * rounding * rounding; ++step) {
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

std::optional<PartSurface> begin_plane(std::span<const Vec3> points) {
  const Vec3 middle = mean_of(points);
  Mat3 spread(0);
  for (const Vec3& p : points) spread += glm::outerProduct(p - middle, p - middle);
  const Vec3 axis = smallest_axis(spread);
  if (!finite(axis)) return std::nullopt;
  return PartSurface{SurfaceKind::plane, middle, axis};
}

std::optional<PartSurface> begin_cylinder(std::span<const Facing> facings, std::span<const Vec3> points) {
  Mat3 spread(0);
  for (const Facing& f : facings) spread += f.weight * glm::outerProduct(f.normal, f.normal);
  const Vec3 axis = smallest_axis(spread);
  if (!finite(axis)) return std::nullopt;
  const auto across = square_to(axis);
  const Vec3 from = points.front();
  std::vector<Vec2> seen;
  seen.reserve(points.size());
  for (const Vec3& p : points) seen.emplace_back(glm::dot(p - from, across[0]), glm::dot(p - from, across[1]));
  const auto circle = fit_circle(seen);
  if (!circle) return std::nullopt;
  return PartSurface{SurfaceKind::cylinder, from + circle->centre.x * across[0] + circle->centre.y * across[1], axis,
                     circle->radius};
}

std::optional<PartSurface> begin_cone(std::span<const Facing> facings, std::span<const Vec3> points) {
  Vec3 mean(0);
  double weights = 0;
  for (const Facing& f : facings) {
    mean += f.weight * f.normal;
    weights += f.weight;
  }
  mean /= weights;
  Mat3 spread(0);
  for (const Facing& f : facings) spread += f.weight * glm::outerProduct(f.normal - mean, f.normal - mean);
  PartSurface cone{.kind = SurfaceKind::cone, .axis = smallest_axis(spread)};
  if (!finite(cone.axis)) return std::nullopt;
  const auto on_axis = meeting_of_normals(facings, cone.axis);
  if (!on_axis) return std::nullopt;
  cone.origin = *on_axis;
  // Fits a line through the heights and radii of the points.
  Vec2 middle(0);
  for (const Vec3& p : points) {
    const Polar polar = polar_of(cone, p);
    middle += Vec2(polar.height, polar.radius) / static_cast<double>(points.size());
  }
  double along = 0, both = 0;
  for (const Vec3& p : points) {
    const Polar polar = polar_of(cone, p);
    along += (polar.height - middle.x) * (polar.height - middle.x);
    both += (polar.height - middle.x) * (polar.radius - middle.y);
  }
  if (!(along > 0)) return std::nullopt;
  cone.slope = both / along;
  cone.origin += middle.x * cone.axis;
  cone.radius = middle.y;
  return cone;
}

std::optional<PartSurface> begin_sphere(std::span<const Vec3> points) {
  const Vec3 middle = mean_of(points);
  NormalEquations<4> equations;
  for (const Vec3& p : points) {
    const Vec3 d = p - middle;
    equations.add({2 * d.x, 2 * d.y, 2 * d.z, 1}, glm::dot(d, d));
  }
  const auto found = equations.solve(0);
  if (!found) return std::nullopt;
  const Vec3 centre((*found)[0], (*found)[1], (*found)[2]);
  const double square = (*found)[3] + glm::dot(centre, centre);
  if (!(square > 0)) return std::nullopt;
  return PartSurface{SurfaceKind::sphere, middle + centre, Vec3(0), std::sqrt(square)};
}

std::optional<PartSurface> begin_torus_by_normals(std::span<const Facing> facings, std::span<const Vec3> points) {
  const Vec3 from = facings.front().middle;
  Mat3 nn(0), nm(0), mm(0);
  for (const Facing& f : facings) {
    const Vec3 moment = glm::cross(f.middle - from, f.normal);
    nn += glm::outerProduct(f.normal, f.normal);
    nm += glm::outerProduct(f.normal, moment);
    mm += glm::outerProduct(moment, moment);
  }
  if (!(std::abs(glm::determinant(nn)) > 1e-12)) return std::nullopt;
  const Mat3 moment_of = -glm::inverse(nn) * nm;
  PartSurface torus{.kind = SurfaceKind::torus, .axis = smallest_axis(mm + glm::transpose(nm) * moment_of)};
  if (!finite(torus.axis)) return std::nullopt;
  torus.origin = from + glm::cross(torus.axis, moment_of * torus.axis);
  std::vector<Vec2> profile;
  profile.reserve(points.size());
  for (const Vec3& p : points) {
    const Polar polar = polar_of(torus, p);
    profile.emplace_back(polar.radius, polar.height);
  }
  const auto circle = fit_circle(profile);
  if (!circle) return std::nullopt;
  torus.radius = circle->centre.x;
  torus.origin += circle->centre.y * torus.axis;
  torus.minor = circle->radius;
  return torus;
}

// Fits z = a + b x + c y + (d x^2 + 2 e x y + f y^2) / 2 + cubic terms over a plane, and returns its curvatures and
// their directions at the middle. Tori with the same curvatures differ in the cubic terms only; without these, the
// curvatures would be wrong by as much.
std::optional<Curvatures> curvatures_of(const Facing& middle, std::span<const Vec3> points) {
  const auto across = square_to(middle.normal);
  double size = 0;
  for (const Vec3& p : points) size = std::max(size, glm::distance(p, middle.middle));
  NormalEquations<10> equations;
  for (const Vec3& p : points) {
    const Vec3 from = (p - middle.middle) / size;
    const double x = glm::dot(from, across[0]), y = glm::dot(from, across[1]);
    equations.add({1, x, y, x * x / 2, x * y, y * y / 2, x * x * x, x * x * y, x * y * y, y * y * y},
                  glm::dot(from, middle.normal));
  }
  const auto found = equations.solve(0);
  if (!found) return std::nullopt;
  const double a = (*found)[0], b = (*found)[1], c = (*found)[2], d = (*found)[3], e = (*found)[4], f = (*found)[5];
  const double root = std::sqrt(1 + b * b + c * c);
  const Vec3 normal = glm::normalize(middle.normal - b * across[0] - c * across[1]);
  // In a frame of the tangent plane at the middle, the second derivatives are nearly those over the given plane.
  const double half_trace = (d + f) / 2, half_difference = (d - f) / 2;
  const double spread = std::hypot(half_difference, e);
  const double angle = portable_atan2(e, half_difference) / 2;
  const Vec3 one = portable_cos(angle) * across[0] + portable_sin(angle) * across[1];
  const Vec3 first = glm::normalize(one - glm::dot(one, normal) * normal);
  return Curvatures{middle.middle + a * size * middle.normal,
                    normal,
                    {(half_trace + spread) / (root * size), (half_trace - spread) / (root * size)},
                    {first, glm::cross(normal, first)}};
}

namespace {

// Cosines and sines of angles over a full turn.
const std::vector<Vec2>& all_turns() {
  static const std::vector<Vec2> turns = [] {
    constexpr int count = 72;
    std::vector<Vec2> all;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / count;
      all.emplace_back(portable_cos(angle), portable_sin(angle));
    }
    return all;
  }();
  return turns;
}

// Returns the best of the surfaces that `make` returns for a principal direction and an angle: a coarse scan, then a
// fine one around its best result.
template <class Make>
std::optional<PartSurface> best_turned(std::span<const Vec3> points, const Make& make) {
  constexpr int stride = 4;
  const std::vector<Vec2>& turns = all_turns();
  const auto count = static_cast<int>(turns.size());
  std::optional<PartSurface> best;
  double least = HUGE_VAL;
  std::array<int, 2> at{};
  const auto consider = [&](int direction, int turn) {
    const auto surface = make(direction, turns[static_cast<std::size_t>((turn + count) % count)]);
    if (!surface) return;
    const double sum = sum_of_squares(*surface, points, least);
    if (!(sum < least)) return;
    least = sum;
    best = surface;
    at = {direction, turn};
  };
  for (const int direction : {0, 1})
    for (int turn = 0; turn < count; turn += stride) consider(direction, turn);
  const auto [direction, middle] = at;
  for (int turn = middle - stride + 1; best && turn < middle + stride; ++turn) consider(direction, turn);
  return best;
}

// A cone that touches the surface, with its generator along direction `g` and the same curvature across it; `turn`
// holds cosine and sine of the angle between its axis and generators.
std::optional<PartSurface> cone_of(const Curvatures& at, int g, const Vec2& turn) {
  const double around = at.value[1 - g];
  const double c = turn.x, s = turn.y;
  if (!(std::abs(around) > 1e-9) || !(c > 0.15) || std::abs(at.value[g]) > std::abs(around)) return std::nullopt;
  const Vec3 outwards = around > 0 ? -at.normal : at.normal;
  const Vec3 radial = c * outwards + s * at.direction[g];
  const double radius = c / std::abs(around);
  return PartSurface{
      SurfaceKind::cone, at.point - radius * radial, c * at.direction[g] - s * outwards, radius, 0, s / c};
}

}  // namespace

std::optional<PartSurface> begin_cone_by_curvatures(const Curvatures& at, std::span<const Vec3> points) {
  return best_turned(points, [&](int direction, const Vec2& turn) { return cone_of(at, direction, turn); });
}

std::optional<PartSurface> begin_torus_by_curvatures(const Curvatures& at, std::span<const Vec3> points) {
  return best_turned(points, [&](int direction, const Vec2& turn) { return torus_of(at, direction, turn); });
}

}  // namespace epura::features
