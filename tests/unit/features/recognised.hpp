// SPDX-License-Identifier: Apache-2.0
// Worlds with recognised parts.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../surfaces/shapes.hpp"
#include "laboratory/shapes.hpp"
#include "scene/transform.hpp"
#include "world/world.hpp"

namespace epura::test {

inline world::World world_of(const Part& part, const std::string& transform = "scale:1") {
  const auto mesh = std::make_shared<const mesh::Mesh>(part.mesh());
  return laboratory::recognised(world::make_world({{mesh, scene::parse_transform(transform)}}));
}

inline Part together(const std::vector<Part>& parts) {
  Part all;
  for (const Part& part : parts) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (std::vector<int> face : part.faces) {
      for (int& v : face) v += first;
      all.faces.push_back(face);
    }
  }
  return all;
}

inline Part moved(Part part, const Vec3& by) {
  return part.move([&](const Vec3& p) { return p + by; });
}

/// A plate with one opening; both outlines run counterclockwise and have the same number of corners.
inline Part plate_between(const std::vector<Vec2>& outer, const std::vector<Vec2>& inner, double height) {
  Part part;
  const int n = static_cast<int>(outer.size());
  for (const auto& [outline, z] : {std::pair(&inner, 0.0), {&outer, 0.0}, {&outer, height}, {&inner, height}})
    for (const Vec2& p : *outline) part.add({p.x, p.y, z});
  for (int ring = 0; ring < 4; ++ring)
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n, next = (ring + 1) % 4 * n;
      part.faces.push_back({ring * n + i, ring * n + j, next + j, next + i});
    }
  return part;
}

inline Part with_opening(const std::vector<Vec2>& opening, double height) {
  std::vector<Vec2> square{{100, -100}, {100, 100}, {-100, 100}, {-100, -100}};
  const int more = static_cast<int>(opening.size() - square.size());
  for (int i = 1; i <= more; ++i) square.emplace_back(-100 + 200.0 * i / (more + 1), -100);
  return plate_between(square, opening, height);
}

struct Bore {
  Vec2 at;
  double radius;
};

/// Square plates 30 wide, which are one where their sides meet.
inline Part plate_with_bores(const std::vector<Bore>& bores) {
  const std::vector<Vec2> square{{15, 15}, {-15, 15}, {-15, -15}, {15, -15}};
  Part part;
  std::map<std::array<double, 3>, int> known;
  std::map<std::vector<int>, std::vector<int>> faces;  // by their sorted vertices
  for (const Bore& bore : bores) {
    const Part cell = plate_with_hole(square, 10, bore.radius, 4);
    std::vector<int> number;
    for (const Vec3& p : cell.points) {
      const Vec3 q = p + Vec3(bore.at, 0);
      const auto [at, is_new] = known.try_emplace({q.x, q.y, q.z}, static_cast<int>(part.points.size()));
      if (is_new) part.add(q);
      number.push_back(at->second);
    }
    for (std::vector<int> face : cell.faces) {
      for (int& v : face) v = number[std::size_t(v)];
      std::vector<int> key = face;
      std::sort(key.begin(), key.end());
      if (!faces.insert({key, face}).second) faces.erase(key);
    }
  }
  for (const auto& [key, face] : faces) part.faces.push_back(face);
  return part;
}

/// Two half circles, `half` to the left and to the right of the origin.
inline std::vector<Vec2> obround(double half, double radius, int steps = 12) {
  return joined({arc({half, 0}, radius, -90, 90, steps), arc({-half, 0}, radius, 90, 270, steps)});
}

}  // namespace epura::test
