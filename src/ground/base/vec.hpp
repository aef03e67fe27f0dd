// SPDX-License-Identifier: Apache-2.0
// The project's linear algebra: GLM in double. Column vectors everywhere: p' = M p.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace epura {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

/// A matrix from its rows, the way it is printed. (GLM stores columns.)
inline Mat4 rows(const Vec4& r0, const Vec4& r1, const Vec4& r2, const Vec4& r3) {
  return glm::transpose(Mat4(r0, r1, r2, r3));
}

/// Twice the signed area of the triangle of the origin, a and b: positive if b is to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

inline Vec2 left_of(const Vec2& direction) { return {-direction.y, direction.x}; }

inline bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Returns the largest 32-bit float that is not above x. (std::nextafter takes much longer.)
inline float rounded_down(double x) {
  const auto rounded = static_cast<float>(x);
  if (!(rounded > x)) return rounded;
  if (rounded == 0) return -std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::int32_t>(rounded);
  return std::bit_cast<float>(rounded > 0 ? bits - 1 : bits + 1);
}

/// An axis-aligned box; empty while min > max.
struct Box {
  Vec3 min{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 max{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  [[nodiscard]] bool empty() const { return !(min.x <= max.x); }
  // Halves first, so that boxes near the largest double have a centre.
  [[nodiscard]] Vec3 centre() const { return min * 0.5 + max * 0.5; }
  [[nodiscard]] Vec3 size() const { return max - min; }
};

}  // namespace epura
