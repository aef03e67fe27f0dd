// SPDX-License-Identifier: Apache-2.0
#include "surfaces/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/circle_fit.hpp"
#include "base/portable_math.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::surfaces {

namespace {

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

}  // namespace

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
    middle += profile_of(cone, p) / static_cast<double>(points.size());
  }
  double along = 0, both = 0;
  for (const Vec3& p : points) {
    const Vec2 from = profile_of(cone, p) - middle;
    along += from.y * from.y;
    both += from.y * from.x;
  }
  if (!(along > 0)) return std::nullopt;
  cone.slope = both / along;
  cone.origin += middle.y * cone.axis;
  cone.radius = middle.x;
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
  for (const Vec3& p : points) profile.push_back(profile_of(torus, p));
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

}  // namespace epura::surfaces
