// SPDX-License-Identifier: Apache-2.0
#include "verify/cover.hpp"

#include <algorithm>
#include <cmath>

namespace epura::verify {

namespace {

// Error of doubles, in half sides of the square, above which rationals are used.
constexpr double rounding_part = 0.1;
// Steepness (depth per length on the page) above which a triangle is a line there; its depth over a point means little.
constexpr double steep_as_a_line = 1e6;
// Distance by which rounding may move corners relative to the point, in half sides of the square.
constexpr double lattice = 2;
// Fractions of the contact tolerance: a triangle less than the first in front of the point certainly does not hide it,
// a triangle more than the second in front of it certainly does.
constexpr double surely_touching = 0.75, surely_apart = 2;

// The triangle in the frame of the ray. Clipping it in plain doubles gives the result that exact clipping gives for
// corners moved by at most `moved`: their own error, and that of a few operations at each of five planes.
struct Facing {
  Polygon<double> polygon;
  double moved = 0;
};

Facing facing(const std::array<Triple<Bounded>, 3>& corners) {
  Facing result;
  double largest = 0, error = 0;
  for (const Triple<Bounded>& p : corners) {
    result.polygon.add({p.x.value, p.y.value, p.z.value});
    for (const Bounded* c : {&p.x, &p.y, &p.z}) {
      largest = std::max(largest, std::abs(c->value));
      error += c->error;  // a sum preserves NaN
    }
  }
  result.moved = error + 64 * 0x1p-53 * largest;
  return result;
}

// A square around a point of the page: half its side is half (1 - k c) + slack at depth c.
template <class N>
struct Square {
  N k, page, half, slack;
};

// The part of a polygon in front of the square and not behind the centre. The conditions are linear in a, b and c, so
// nothing is divided before clipping.
template <class N>
Polygon<N> over_square(const Polygon<N>& polygon, const std::optional<N>& eye, const Square<N>& square) {
  Polygon<N> rest = polygon;
  if (eye) rest = clip(rest, [&](const Triple<N>& p) { return N(*eye - p.z); });
  const auto side = [&](const Triple<N>& p) { return N(square.half - square.half * square.k * p.z + square.slack); };
  rest = clip(rest, [&](const Triple<N>& p) { return N(side(p) - square.page * p.x); });
  rest = clip(rest, [&](const Triple<N>& p) { return N(side(p) + square.page * p.x); });
  rest = clip(rest, [&](const Triple<N>& p) { return N(side(p) - square.page * p.y); });
  return clip(rest, [&](const Triple<N>& p) { return N(side(p) + square.page * p.y); });
}

// Returns 1 + length of the gradient of depth over the page; infinite for a triangle that may be a line there. The
// plane alpha a + beta b + gamma c = rho is alpha X / F + beta Y / F + (gamma - rho k) Z / D = rho.
template <class N>
double steepness(const std::array<Triple<N>, 3>& corners, const Sight<N>& sight) {
  const Triple<N> s = corners[1] - corners[0], t = corners[2] - corners[0];
  const N zero(0);
  const Triple<N> normal{s.y * t.z - s.z * t.y, s.z * t.x - s.x * t.z, s.x * t.y - s.y * t.x};
  const N along_ray = normal.z - dot(normal, corners[0]) * sight.inverse_distance;
  const double facing_part = std::abs(value_of(along_ray));
  if (!(facing_part > 1e3 * error_of(along_ray))) return HUGE_VAL;
  return 1 + std::hypot(value_of(normal.x), value_of(normal.y)) / facing_part * sight.depth / sight.page;
}

struct DepthRange {
  double min = HUGE_VAL, max = -HUGE_VAL;

  void add(double depth) {
    min = std::min(min, depth);
    max = std::max(max, depth);
  }
};

// Whether a piece of surface lies within the depth limits: entirely, not at all, or undetermined.
template <class N>
std::optional<bool> within_limits(const Sight<N>& sight, const DepthRange& c, double error) {
  bool all = true;
  const auto respect = [&](double inside_min, double inside_max, double slack) {
    if (inside_max < -slack) return false;
    if (!(inside_min > slack)) all = false;
    return true;
  };
  if (sight.nearest) {
    const double limit = value_of(*sight.nearest);
    if (!respect(limit - c.max, limit - c.min, error + error_of(*sight.nearest))) return false;
  }
  if (sight.farthest) {
    const double limit = value_of(*sight.farthest);
    if (!respect(c.min - limit, c.max - limit, error + error_of(*sight.farthest))) return false;
  }
  return all ? std::optional(true) : std::nullopt;
}

struct Piece3 {
  Polygon<double> polygon;  // in the frame of the ray
  double moved;
  double steepness;
};

// Returns the effect of the part of a surface over the square, or nothing if it does not hide the point.
template <class N>
std::optional<Portion> portion_of(const Piece3& piece, const Sight<N>& sight, const Tolerance& tolerance, bool joined) {
  const double k = value_of(sight.inverse_distance);
  DepthRange depth, c;
  double depth_error = 0;
  for (std::size_t i = 0; i < piece.polygon.count; ++i) {
    const double along_ray = piece.polygon.corner[i].z, foreshortening = 1 - k * along_ray;
    c.add(along_ray);
    depth.add(sight.depth * along_ray / foreshortening);
    depth_error = std::max(depth_error, 2 * sight.depth * piece.moved / (foreshortening * foreshortening));
  }
  const std::optional<bool> seen = within_limits(sight, c, piece.moved);
  if (seen == false) return std::nullopt;
  const bool line = !(piece.steepness < steep_as_a_line);
  // Corners are rounded to the page grid, which moves depth in proportion to the steepness of the triangle.
  const double joined_by = line ? 0 : -lattice * tolerance.sideways() * piece.steepness;
  const double touching = joined ? joined_by : surely_touching * tolerance.contact * (line ? 1 : piece.steepness);
  if (depth.max + depth_error < touching) return std::nullopt;
  if (!seen || line || !(depth.min - depth_error > surely_apart * tolerance.contact * piece.steepness))
    return Portion{-1, false, depth.min, {}};
  Portion portion{-1, true, depth.min, {}};
  for (std::size_t i = 0; i < piece.polygon.count; ++i) {
    const Triple<double>& p = piece.polygon.corner[i];
    const double scale = sight.page / (1 - k * p.z) / tolerance.sideways();
    portion.corner.emplace_back(p.x * scale, p.y * scale);
  }
  return portion;
}

std::optional<Portion> look_exactly(const Sight<Exact>& sight, const std::array<Vec3, 3>& corners,
                                    const Tolerance& tolerance, bool joined) {
  std::array<Triple<Exact>, 3> local;
  Polygon<Exact> polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    local[i] = sight.local(corners[i]);
    polygon.add(local[i]);
  }
  const Polygon<Exact> cut = over_square<Exact>(
      polygon, sight.eye, {sight.inverse_distance, Exact(sight.page), Exact(tolerance.sideways()), Exact(0)});
  if (cut.count == 0) return std::nullopt;
  Piece3 piece{{}, 0, steepness(local, sight)};
  double largest = 0;
  for (std::size_t i = 0; i < cut.count; ++i) {
    const Triple<Exact>& p = cut.corner[i];
    piece.polygon.add({p.x.get_d(), p.y.get_d(), p.z.get_d()});
    largest = std::max(largest, std::abs(piece.polygon.corner[i].z));
  }
  piece.moved = 4 * 0x1p-53 * largest;
  return portion_of(piece, sight, tolerance, joined);
}

}  // namespace

Lookout::Lookout(const Viewing& viewing, const Tolerance& tolerance, const std::array<Vec3, 2>& line, double t)
    : viewing_(&viewing),
      tolerance_(&tolerance),
      line_(line),
      t_(t),
      sight_(sight_from(viewing, position_on<Bounded>(line, t))) {}

std::optional<Portion> Lookout::look(const std::array<Vec3, 3>& corners, int triangle, bool joined) const {
  const auto named = [&](std::optional<Portion> portion) {
    if (portion) portion->triangle = triangle;
    return portion;
  };
  const std::array<Triple<Bounded>, 3> local{sight_.local(corners[0]), sight_.local(corners[1]),
                                             sight_.local(corners[2])};
  const Facing face = facing(local);
  const double page = sight_.page, half = tolerance_->sideways();
  const double slack = 2 * page * face.moved;
  const Bounded& k = sight_.inverse_distance;
  if (std::isfinite(slack) && k.error <= 0x1p-44 * k.value) {
    const auto eye = sight_.eye ? std::optional(sight_.eye->value) : std::nullopt;
    const Polygon<double> cut = over_square(face.polygon, eye, Square<double>{k.value, page, half, slack});
    if (cut.count == 0) return std::nullopt;
    double min_foreshortening = 1;
    for (std::size_t i = 0; i < cut.count; ++i)
      min_foreshortening = std::min(min_foreshortening, 1 - k.value * cut.corner[i].z);
    if (slack <= rounding_part * half * min_foreshortening)
      return named(portion_of(Piece3{cut, face.moved, steepness(local, sight_)}, sight_, *tolerance_, joined));
  }
  return named(look_exactly(sight_from(*viewing_, position_on<Exact>(line_, t_)), corners, *tolerance_, joined));
}

}  // namespace epura::verify
