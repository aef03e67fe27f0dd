// SPDX-License-Identifier: Apache-2.0
#include "drawing/page_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

Vec2 PageCurve::derivative(double parameter) const {
  return is_straight_ ? shape_.u : portable_cos(parameter) * shape_.v - portable_sin(parameter) * shape_.u;
}

double PageCurve::parameter_of(const Vec2& point) const {
  return is_straight_ ? glm::dot(point - shape_.centre, shape_.u) / glm::dot(shape_.u, shape_.u)
                      : shape_.angle_of(point);
}

double PageCurve::parameter_near_part(const Vec2& place) const {
  const double parameter = parameter_of(place), middle = (range_[0] + range_[1]) / 2;
  return is_straight_ ? parameter : middle + std::remainder(parameter - middle, 2 * std::numbers::pi);
}

bool PageCurve::is_in_part(const Vec2& place) const {
  const double parameter = parameter_near_part(place);
  return range_[0] <= parameter && parameter <= range_[1];
}

Vec2 PageCurve::end_near(const Vec2& place) const {
  return at(std::clamp(parameter_near_part(place), range_[0], range_[1]));
}

std::optional<Vec2> crossing_near(const PageCurve& one, const PageCurve& other, const Vec2& point) {
  double s = one.parameter_of(point), t = other.parameter_of(point);
  for (int step = 0; step < newton_steps; ++step) {
    const Vec2 gap = other.at(t) - one.at(s), along = one.derivative(s), across = other.derivative(t);
    const double area = cross(along, across), lengths = glm::length(along) * glm::length(across);
    if (!(std::abs(area) > parallel_sine * lengths)) return std::nullopt;
    const double ds = cross(gap, across) / area, dt = cross(gap, along) / area;
    s += ds;
    t += dt;
    if (std::max(std::abs(ds) * glm::length(along), std::abs(dt) * glm::length(across)) <= rounding_mm)
      return one.at(s);
  }
  return std::nullopt;
}

}  // namespace epura::drawing
