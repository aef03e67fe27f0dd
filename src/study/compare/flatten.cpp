#include "study/compare/flatten.hpp"

#include <algorithm>
#include <cmath>

namespace epura {

int parts_of_curve(double sagitta) {
  constexpr double flatness = 1e-4;
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(sagitta / flatness)), 1.0, 10000.0));
}

void append_cubic(std::vector<Vec2>& points, Vec2 from, Vec2 a, Vec2 b, Vec2 to) {
  const double bend = std::max(glm::length(from - 2.0 * a + b), glm::length(a - 2.0 * b + to));
  const int parts = parts_of_curve(0.75 * bend);
  for (int i = 1; i < parts; ++i) {
    const double t = double(i) / parts, s = 1 - t;
    points.push_back(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
  }
  points.push_back(to);
}

}  // namespace epura
