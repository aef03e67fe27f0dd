// SPDX-License-Identifier: Apache-2.0
// Finds the point of a segment that is nearest to a given point, on the page (Vec2) or in space (Vec3).
#pragma once

#include <algorithm>

#include "base/vec.hpp"

namespace epura {

/// Returns 0 at `from` to 1 at `to`; 0 if these coincide.
template <class Vec>
double nearest_parameter(const Vec& p, const Vec& from, const Vec& to) {
  const Vec along = to - from;
  const double square = glm::dot(along, along);
  return square > 0 ? std::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0;
}

template <class Vec>
Vec nearest_on_segment(const Vec& p, const Vec& from, const Vec& to) {
  return from + nearest_parameter(p, from, to) * (to - from);
}

template <class Vec>
double distance_to_segment(const Vec& p, const Vec& from, const Vec& to) {
  return glm::distance(p, nearest_on_segment(p, from, to));
}

}  // namespace epura
