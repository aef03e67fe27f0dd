// SPDX-License-Identifier: Apache-2.0
// Common code of the generators of large scenes: a list of triangles, pseudorandom numbers, and the file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace epura::bench {

using Point = std::array<double, 3>;

struct Scene {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;

  int add(double x, double y, double z) {
    points.push_back({x, y, z});
    return static_cast<int>(points.size()) - 1;
  }
  void quad(int a, int b, int c, int d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
};

/// The box between two corners, counterclockwise as seen from outside.
void add_box(Scene& scene, const Point& min, const Point& max);

/// A rectangle at one height, counterclockwise as seen from above.
void add_rectangle(Scene& scene, const std::array<double, 2>& min, const std::array<double, 2>& max, double z);

/// The same sequence everywhere: the linear congruential generator of Numerical Recipes, second edition, 7.1.
class Random {
 public:
  /// 0 ... 65535
  std::uint32_t bits() { return (state_ = state_ * 1664525 + 1013904223) >> 16; }
  /// 0 <= number < 1
  double number() {
    const double high = bits();
    return (high + bits() / 65536.0) / 65536;
  }
  double between(double min, double max) { return min + (max - min) * number(); }

 private:
  std::uint32_t state_ = 1;
};

/// Binary PLY, little-endian, with double coordinates.
std::string ply_bytes(const Scene& scene);

}  // namespace epura::bench
