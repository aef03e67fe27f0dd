// SPDX-License-Identifier: Apache-2.0
// What the tests of this folder share: projections by request, images of points.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "errors.hpp"
#include "projection/catalogue.hpp"
#include "projection/matrices.hpp"

namespace epura::test {

inline const std::vector<std::filesystem::path>& built_plugins() {
  static const std::vector<std::filesystem::path> folders{EPURA_TEST_PLUGINS};
  return folders;
}

inline projection::Projection make(const std::string& request, const Box& box) {
  static std::map<std::string, projection::ProjectionEntry> found;  // one process each, however often it is asked
  const scene::ProjectionRequest parsed = scene::parse_request(request);
  if (!found.contains(parsed.name))
    found.emplace(parsed.name, projection::find_projection(parsed.name, built_plugins()));
  return projection::make_projection(found.at(parsed.name), parsed, box);
}

/// Neither centred nor a cube.
inline Box a_box() { return {{-1, -2, 0.5}, {3, 1, 4}}; }

inline Vec4 image(const projection::Projection& p, const Vec3& x) { return projection::view_matrix(p) * Vec4(x, 1); }
/// Place on the plane.
inline Vec2 place(const projection::Projection& p, const Vec3& x) {
  const Vec4 h = image(p, x);
  return Vec2(h) / h.w;
}
inline double depth(const projection::Projection& p, const Vec3& x) {
  const Vec4 h = image(p, x);
  return h.z / h.w;
}
/// How a step along a world vector appears under a parallel projection.
inline Vec2 step(const projection::Projection& p, const Vec3& by) { return place(p, by) - place(p, Vec3(0)); }

inline double degrees(double radians) { return radians * 180 / 3.14159265358979323846; }
inline double cot(double radians) { return 1 / std::tan(radians); }

inline void expect_near(const Mat4& a, const Mat4& b, double tolerance) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], tolerance) << "row " << r << ", column " << c;
}
template <int N>
void expect_near(const glm::vec<N, double>& a, const glm::vec<N, double>& b, double tolerance) {
  for (int i = 0; i < N; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

}  // namespace epura::test
