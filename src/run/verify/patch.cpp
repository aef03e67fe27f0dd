// SPDX-License-Identifier: Apache-2.0
#include "verify/patch.hpp"

#include <cmath>
#include <utility>

namespace epura::verify {

namespace {

// Pieces with a smaller area are due to rounding.
constexpr double min_area = 1e-9;

double signed_area(const ConvexPolygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum / 2;
}

// The part of a polygon on the side of the line a, b where `sign` times the cross product is positive.
ConvexPolygon side_of(const ConvexPolygon& polygon, const Vec2& a, const Vec2& b, double sign) {
  ConvexPolygon rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& from = polygon[i];
    const Vec2& to = polygon[(i + 1) % polygon.size()];
    const double at_from = sign * cross(b - a, from - a), at_to = sign * cross(b - a, to - a);
    if (at_from >= 0) rest.push_back(from);
    if ((at_from >= 0) != (at_to >= 0)) rest.push_back(from + at_from / (at_from - at_to) * (to - from));
  }
  return rest;
}

// Appends `piece` without `cover`: the part outside the first side, then the part of the rest outside the second, and
// so on.
void subtract(ConvexPolygon piece, const ConvexPolygon& cover, std::vector<ConvexPolygon>& rest) {
  const double sign = signed_area(cover) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < cover.size(); ++i) {
    const Vec2& a = cover[i];
    const Vec2& b = cover[(i + 1) % cover.size()];
    if (glm::distance(a, b) < min_area) continue;
    ConvexPolygon outside = side_of(piece, a, b, -sign);
    if (std::abs(signed_area(outside)) > min_area) rest.push_back(std::move(outside));
    piece = side_of(piece, a, b, sign);
  }
}

}  // namespace

double uncovered(const std::vector<ConvexPolygon>& polygons) {
  std::vector<ConvexPolygon> pieces{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const ConvexPolygon& polygon : polygons) {
    if (std::abs(signed_area(polygon)) <= min_area) continue;
    std::vector<ConvexPolygon> rest;
    for (ConvexPolygon& piece : pieces) subtract(std::move(piece), polygon, rest);
    pieces = std::move(rest);
    if (pieces.empty()) return 0;
  }
  double area = 0;
  for (const ConvexPolygon& piece : pieces) area += std::abs(signed_area(piece));
  return area;
}

}  // namespace epura::verify
