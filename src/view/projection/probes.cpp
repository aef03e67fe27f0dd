// SPDX-License-Identifier: Apache-2.0
#include "projection/probes.hpp"

#include <algorithm>
#include <cmath>

namespace epura::projection {

namespace {

// Plausible values for numbers, pairs, windows, directions and positions, which use the first components.
constexpr double patterns[][8] = {
    {20, 3, 9, 11, 2, 5, 1, 4},    {7, -2, 3, 4, 5, 6, 1, 2},       {3, 9, -11, 13, 1, 2, 4, 5},
    {1, -40, 2, 3, 4, 5, 6, 7},    {0.7, -1, 1.1, 2, 3, 4, 5, 6},   {-0.3, -2, 3, 4, 5, 6, 7, 8},
    {-7, -11, 13, 15, 1, 2, 3, 4}, {-20, 3, 5, 9, 1, 2, 4, 6},      {30, 3, 40, 50, 60, 1, 2, 3},
    {9, -11, 13, 17, 19, 1, 2, 3}, {0.2, -1, 1.1, 3, 0.5, 2, 4, 1}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}};

std::vector<std::vector<double>> every_choice(const Parameter& parameter) {
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) values.push_back({static_cast<double>(i)});
  return values;
}

}  // namespace

std::vector<Box> extreme_boxes() {
  return {Box{}, Box{Vec3(2, 3, 4), Vec3(2, 3, 4)}, Box{Vec3(-1e100), Vec3(1e100)}, Box{Vec3(1e-100), Vec3(2e-100)},
          Box{{1e9, -1e9, 0}, {1e9 + 1, -1e9 + 1, 1}}};
}

std::vector<std::vector<double>> probe_values(const Parameter& parameter) {
  if (parameter.type == ParameterType::choice) return every_choice(parameter);
  std::vector<std::vector<double>> values = end_values(parameter);
  const std::size_t count = parameter.initial.size();
  if (const double middle = parameter.min / 2 + parameter.max / 2; std::isfinite(middle))
    values.emplace_back(count, middle);
  for (const auto& pattern : patterns)
    if (std::all_of(pattern, pattern + count, [&](double x) { return x >= parameter.min && x <= parameter.max; }))
      values.emplace_back(pattern, pattern + count);
  return values;
}

std::vector<std::vector<double>> end_values(const Parameter& parameter) {
  if (parameter.type == ParameterType::choice) return every_choice(parameter);
  std::vector<std::vector<double>> values;
  for (const double end : {parameter.min, parameter.max})
    if (std::isfinite(end)) values.emplace_back(parameter.initial.size(), end);
  return values;
}

std::array<Vec3, 8> points_before_viewer(const Projection& p, const Box& box) {
  std::array<Vec3, 8> points;
  const double eye = glm::dot(p.projector - p.point, p.n);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 corner((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                      (i & 4) != 0 ? box.max.z : box.min.z);
    const double height = glm::dot(corner - p.point, p.n);
    points[i] = p.central && height > eye / 2 ? corner - height * p.n : corner;
  }
  return points;
}

}  // namespace epura::projection
