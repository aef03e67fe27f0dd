// SPDX-License-Identifier: Apache-2.0
#include "drawing/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

/// The parameters of a line at which it crosses the circle, or the lines through the sides of the rectangle.
using CutParameters = std::vector<double>;

bool is_inside(const Boundary& boundary, const Vec2& p) {
  const Vec2 d = p - boundary.centre;
  if (boundary.round) return glm::dot(d, d) <= boundary.half.x * boundary.half.x;
  return std::abs(d.x) <= boundary.half.x && std::abs(d.y) <= boundary.half.y;
}

// The roots of |f + t d|^2 = r^2, without cancellation, the smaller one first; nothing if the line touches the circle.
std::optional<std::array<double, 2>> circle_crossings(const Vec2& f, const Vec2& d, double radius) {
  const double a = glm::dot(d, d), b = glm::dot(f, d), c = glm::dot(f, f) - radius * radius;
  const double root = b * b - a * c;
  if (!(root > 0 && a > 0)) return std::nullopt;
  const double q = -(b + (b < 0 ? -std::sqrt(root) : std::sqrt(root)));
  return std::array{std::min(q / a, c / q), std::max(q / a, c / q)};
}

// The parameters between which a line is between the sides of a rectangle that are perpendicular to an axis.
std::optional<std::array<double, 2>> side_crossings(double f, double d, double half) {
  if (d == 0) return std::abs(f) <= half ? std::optional(std::array{-HUGE_VAL, HUGE_VAL}) : std::nullopt;
  const double one = (-half - f) / d, other = (half - f) / d;
  return std::array{std::min(one, other), std::max(one, other)};
}

CutParameters crossings_of(const Boundary& boundary, const Vec2& from, const Vec2& to) {
  const Vec2 f = from - boundary.centre, d = to - from;
  CutParameters places;
  const auto add = [&](const std::optional<std::array<double, 2>>& crossings) {
    if (crossings) places.insert(places.end(), crossings->begin(), crossings->end());
  };
  if (boundary.round)
    add(circle_crossings(f, d, boundary.half.x));
  else
    for (const int axis : {0, 1}) add(side_crossings(f[axis], d[axis], boundary.half[axis]));
  std::erase_if(places, [](double t) { return !(t > 0 && t < 1); });
  std::sort(places.begin(), places.end());
  return places;
}

Vec2 nearest_inside(const Boundary& boundary, const Vec2& p) {
  if (is_inside(boundary, p)) return p;
  const Vec2 d = p - boundary.centre;
  if (boundary.round) return boundary.centre + (boundary.half.x / glm::length(d)) * d;
  return boundary.centre + glm::clamp(d, -boundary.half, boundary.half);
}

// Appends the images of a line that is outside a circle, without its beginning: an arc.
void add_arc(std::vector<Vec2>& ring, const Boundary& circle, const Vec2& from, const Vec2& to) {
  const Vec2 a = from - circle.centre, b = to - circle.centre;
  const double turn = portable_atan2(cross(a, b), glm::dot(a, b));
  const double step = std::sqrt(8 * off_the_arc / circle.half.x);  // its sagitta is r step^2 / 8
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step)));
  const double start = portable_atan2(a.y, a.x);
  for (int i = 1; i < steps; ++i) {
    const double angle = start + turn * i / steps;
    ring.push_back(circle.centre + circle.half.x * Vec2(portable_cos(angle), portable_sin(angle)));
  }
  ring.push_back(nearest_inside(circle, to));
}

// Taking each point to the nearest one inside does not change how often an outline winds around a point inside.
std::vector<Vec2> ring_inside(const Boundary& boundary, const std::vector<Vec2>& outline) {
  std::vector<Vec2> ring;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &from = outline[i], &to = outline[(i + 1) % outline.size()];
    CutParameters places = crossings_of(boundary, from, to);
    places.push_back(1);
    double before = 0;
    for (const double t : places) {
      check(before <= t, "crossings of a line are in order");
      const Vec2 p = from + before * (to - from), q = t == 1 ? to : from + t * (to - from);
      if (boundary.round && !is_inside(boundary, (p + q) / 2.0))
        add_arc(ring, boundary, p, q);
      else
        ring.push_back(nearest_inside(boundary, q));
      before = t;
    }
  }
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

void add_angle(std::vector<double>& angles, double angle) {
  const double whole = 2 * std::numbers::pi;
  angles.push_back(angle < 0 ? angle + whole : angle);
}

// Where a circle crosses another, or the lines through the sides of a rectangle.
std::vector<double> angles_at(const Boundary& boundary, const Vec2& centre, double radius) {
  std::vector<double> angles;
  const Vec2 apart = boundary.centre - centre;
  if (boundary.round) {
    const double distance = glm::length(apart), r = boundary.half.x;
    const double cosine = (distance * distance + radius * radius - r * r) / (2 * distance * radius);
    if (!(distance > 0) || !(std::abs(cosine) < 1)) return {};
    const double middle = portable_atan2(apart.y, apart.x);
    const double turn = portable_atan2(std::sqrt(1 - cosine * cosine), cosine);
    for (const double angle : {middle - turn, middle + turn})
      add_angle(angles, angle > std::numbers::pi ? angle - 2 * std::numbers::pi : angle);
  } else {
    for (const int axis : {0, 1})
      for (const double side : {apart[axis] - boundary.half[axis], apart[axis] + boundary.half[axis]}) {
        if (!(std::abs(side) < radius)) continue;
        const double other = std::sqrt((radius - side) * (radius + side));
        for (const double across : {-other, other})
          add_angle(angles, axis == 0 ? portable_atan2(across, side) : portable_atan2(side, across));
      }
  }
  check(angles.size() <= 8, "a circle crosses each side of a boundary twice at most");
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace

std::optional<std::array<double, 2>> part_inside(const Boundary& boundary, const Vec2& from, const Vec2& to) {
  const Vec2 f = from - boundary.centre, d = to - from;
  std::array<double, 2> part{0, 1};
  const auto cut = [&part](const std::optional<std::array<double, 2>>& crossings) {
    part = crossings ? std::array{std::max(part[0], (*crossings)[0]), std::min(part[1], (*crossings)[1])}
                     : std::array{1.0, 0.0};
  };
  if (boundary.round)
    cut(circle_crossings(f, d, boundary.half.x));
  else
    for (const int axis : {0, 1}) cut(side_crossings(f[axis], d[axis], boundary.half[axis]));
  check(!(part[0] < part[1]) || (part[0] >= 0 && part[1] <= 1), "what is inside is a part of the line");
  return part[0] < part[1] ? std::optional(part) : std::nullopt;
}

std::vector<std::vector<Vec2>> area_inside(const Boundary& boundary, const std::vector<std::vector<Vec2>>& rings) {
  std::vector<std::vector<Vec2>> inside;
  for (const std::vector<Vec2>& outline : rings) {
    std::vector<Vec2> ring = ring_inside(boundary, outline);
    const double least = rounding_part * glm::dot(boundary.half, boundary.half);
    if (ring.size() >= 3 && std::abs(twice_area(ring)) > least) inside.push_back(std::move(ring));
  }
  return inside;
}

double twice_area(const std::vector<Vec2>& ring) {
  double area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) area += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  return area;
}

std::vector<AngleRange> circle_inside(const Boundary& boundary, const Vec2& centre, double radius) {
  const double whole = 2 * std::numbers::pi;
  const auto is_inside_at = [&](double angle) {
    return is_inside(boundary, centre + radius * Vec2(portable_cos(angle), portable_sin(angle)));
  };
  const std::vector<double> angles = angles_at(boundary, centre, radius);
  if (angles.empty()) return is_inside_at(0) ? std::vector<AngleRange>{{0, whole}} : std::vector<AngleRange>{};
  std::vector<AngleRange> parts;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double from = angles[i], to = i + 1 < angles.size() ? angles[i + 1] : angles[0] + whole;
    if (!(to > from) || !is_inside_at((from + to) / 2)) continue;
    if (!parts.empty() && parts.back().to == from)
      parts.back().to = to;
    else
      parts.push_back({from, to});
  }
  if (parts.size() > 1 && parts.back().to == parts.front().from + whole) {
    parts.front().from = parts.back().from - whole;
    parts.pop_back();
  }
  for (const AngleRange& part : parts)
    check(part.from < part.to && part.to - part.from <= whole * (1 + rounding_part), "an arc is a part of its circle");
  return parts;
}

}  // namespace epura::drawing
