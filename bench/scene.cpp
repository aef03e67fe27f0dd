// SPDX-License-Identifier: Apache-2.0
#include "scene.hpp"

#include <bit>

namespace epura::bench {

namespace {

template <class Value>
void append(std::string& bytes, Value value) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void add_box(Scene& scene, const Point& min, const Point& max) {
  std::array<int, 8> v{};
  for (int i = 0; i < 8; ++i)
    v[i] = scene.add((i & 1) != 0 ? max[0] : min[0], (i & 2) != 0 ? max[1] : min[1], (i & 4) != 0 ? max[2] : min[2]);
  for (const auto& f : std::array<std::array<int, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}})
    scene.quad(v[f[0]], v[f[1]], v[f[2]], v[f[3]]);
}

void add_rectangle(Scene& scene, const std::array<double, 2>& min, const std::array<double, 2>& max, double z) {
  const int first = scene.add(min[0], min[1], z);
  scene.add(max[0], min[1], z);
  scene.add(max[0], max[1], z);
  scene.add(min[0], max[1], z);
  scene.quad(first, first + 1, first + 2, first + 3);
}

std::string ply_bytes(const Scene& scene) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(scene.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(scene.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + 24 * scene.points.size() + 13 * scene.triangles.size());
  for (const Point& p : scene.points)
    for (const double c : p) append(bytes, c);
  for (const auto& t : scene.triangles) {
    append(bytes, std::uint8_t{3});
    for (const int v : t) append(bytes, std::int32_t{v});
  }
  return bytes;
}

}  // namespace epura::bench
