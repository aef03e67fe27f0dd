// SPDX-License-Identifier: Apache-2.0
#include "geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace samples {

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point area_vector(std::span<const Point> polygon) {
  Point sum = {0, 0, 0};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return sum;
}

bool is_planar(const Loop& corners) {
  constexpr double flat = 1e-5;
  const Point normal = area_vector(corners);
  const double length = std::sqrt(dot(normal, normal));
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Point& p) { return std::abs(dot(p - corners[0], normal)) <= flat * length; });
}

Loop place(const Outline& outline, const Frame& frame) {
  Loop loop;
  for (const auto& [x, y] : outline) {
    loop.push_back(frame.origin + x * frame.u + y * frame.v);
  }
  return loop;
}

Loop shifted(Loop loop, const Point& step) {
  for (Point& p : loop) {
    p = p + step;
  }
  return loop;
}

Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

Outline rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Outline circle(double radius, int segments, const Point2& centre) {
  Outline outline = arc(centre, radius, 0, 360, segments);
  outline.pop_back();
  return outline;
}

Outline arc(const Point2& centre, double radius, double from, double to, int segments) {
  Outline points;
  for (int i = 0; i <= segments; ++i) {
    const double angle = from + (to - from) * i / segments;
    points.push_back({centre[0] + radius * cos_deg(angle), centre[1] + radius * sin_deg(angle)});
  }
  return points;
}

std::vector<Outline> bolt_circle(int count, double pitch_radius, double radius, int segments, double angle) {
  std::vector<Outline> holes;
  for (int i = 0; i < count; ++i) {
    const double at = angle + 360.0 * i / count;
    holes.push_back(circle(radius, segments, {pitch_radius * cos_deg(at), pitch_radius * sin_deg(at)}));
  }
  return holes;
}

Loop ring(const Frame& frame, double radius, int segments) { return place(circle(radius, segments), frame); }

double cos_deg(double angle) { return std::cos(angle * std::numbers::pi / 180); }
double sin_deg(double angle) { return std::sin(angle * std::numbers::pi / 180); }

}  // namespace samples
