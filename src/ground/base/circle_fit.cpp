// SPDX-License-Identifier: Apache-2.0
#include "base/circle_fit.hpp"

#include <algorithm>
#include <cmath>

namespace epura {

std::optional<FittedCircle> fit_circle(std::span<const Vec2> points) {
  const auto count = static_cast<double>(points.size());
  Vec2 middle(0);
  for (const Vec2& p : points) middle += p / count;
  // Sums of products of offsets from the middle, with which only two normal equations remain.
  double xx = 0, xy = 0, yy = 0;
  Vec2 cubes(0);
  for (const Vec2& p : points) {
    const Vec2 d = p - middle;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    cubes += glm::dot(d, d) * d;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-20 * (xx + yy) * (xx + yy))) return std::nullopt;
  const Vec2 offset = Vec2(yy * cubes.x - xy * cubes.y, xx * cubes.y - xy * cubes.x) / (2 * determinant);
  FittedCircle circle{middle + offset, std::sqrt(glm::dot(offset, offset) + (xx + yy) / count), 0};
  for (const Vec2& p : points)
    circle.deviation = std::max(circle.deviation, std::abs(glm::distance(p, circle.centre) - circle.radius));
  return circle;
}

}  // namespace epura
