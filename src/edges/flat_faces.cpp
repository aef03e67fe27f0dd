// SPDX-License-Identifier: Apache-2.0
#include "edges/flat_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace epura {

namespace {

// Pairs within smaller faces are few.
constexpr std::size_t least_triangles = 256;

Vec3 normal_of(const World& world, std::span<const Vec3> points, int triangle) {
  const auto& [a, b, c] = world.triangles[triangle];
  return glm::cross(points[b] - points[a], points[c] - points[a]);
}

bool is_flat(const World& world, std::span<const Vec3> points, double contact, std::span<const int> face) {
  const auto size = [&](int t) { return glm::length(normal_of(world, points, t)); };
  const int largest = *std::max_element(face.begin(), face.end(), [&](int a, int b) { return size(a) < size(b); });
  if (!(size(largest) > 0)) return false;
  const Vec3 normal = normal_of(world, points, largest) / size(largest);
  const Vec3& origin = points[world.triangles[largest][0]];
  return std::all_of(face.begin(), face.end(), [&](int t) {
    const auto& corners = world.triangles[t];
    return std::all_of(corners.begin(), corners.end(),
                       [&](int v) { return std::abs(glm::dot(normal, points[v] - origin)) <= contact; });
  });
}

}  // namespace

std::vector<int> flat_faces(const World& world, std::span<const Vec3> points, double contact,
                            const std::vector<int>& triangles) {
  std::vector<int> faces;
  int count = 0;
  std::size_t begin = 0;
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    const std::vector<int>& polygon = world.models[model].mesh->polygon;
    const int first = world.first_triangle[model], behind = first + static_cast<int>(polygon.size());
    while (begin < triangles.size() && triangles[begin] < behind) {
      const int number = polygon[triangles[begin] - first];
      std::size_t end = begin + 1;
      while (end < triangles.size() && triangles[end] < behind && polygon[triangles[end] - first] == number) ++end;
      const std::span<const int> face = std::span(triangles).subspan(begin, end - begin);
      if (face.size() >= least_triangles && is_flat(world, points, contact, face)) {
        faces.resize(triangles.size(), -1);
        std::fill(faces.begin() + static_cast<std::ptrdiff_t>(begin), faces.begin() + static_cast<std::ptrdiff_t>(end),
                  count++);
      }
      begin = end;
    }
  }
  return faces;
}

}  // namespace epura
