// The project's linear algebra: GLM in double. Column vectors everywhere: p' = M p.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

inline bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// An axis-aligned box; empty while least > most.
struct Box {
  Vec3 least{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Vec3& p) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  [[nodiscard]] bool empty() const { return !(least.x <= most.x); }
  // Halves first, so that boxes near the largest double have a centre.
  [[nodiscard]] Vec3 centre() const { return least * 0.5 + most * 0.5; }
  [[nodiscard]] Vec3 size() const { return most - least; }
};

}  // namespace epura
