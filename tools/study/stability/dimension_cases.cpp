// SPDX-License-Identifier: Apache-2.0
// Dimensions: the number as it is written, of lengths and angles that are known. The map has no influence on it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "dimensions/measure.hpp"
#include "laboratory/shapes.hpp"
#include "study/stability/case.hpp"

namespace epura::stability {

namespace {

constexpr int decimals = 15;

// The number of a dimension of `type` between vertices, in the view along z.
double written(const Lab& lab, const Shape& shape, DimensionType type, const std::vector<int>& vertices) {
  const Result result = lab.draw(recognised(world_of(shape)), {from_above()});
  scene::DimensionDescription description;
  description.where = "dimension";
  description.type = {type, "study"};
  for (const int vertex : vertices) description.anchors.push_back(std::array{0, vertex});
  const auto anchored = sheet::find_anchors(result.world, {&description, 1});
  sheet::Notation notation;
  notation.decimals = decimals;
  std::string text = sheet::measure(result.drawing, anchored.front(), notation).text.line();
  const auto is_sign = [](char c) { return !(c >= '0' && c <= '9') && c != '.' && c != '-' && c != '+' && c != 'e'; };
  text.erase(std::remove_if(text.begin(), text.end(), is_sign), text.end());
  return parse_number(text).value_or(NAN);
}

// A step in the outline of a plate. The number has 15 decimals; a length between coordinates near 1 is rounded as
// these.
Measured small_step(const Lab& lab, double size) {
  const Shape plate = prism({{0, 0}, {1, 0}, {1, 1 - size}, {0.5, 1 - size}, {0.5, 1}, {0, 1}}, 1);
  return {length("text", size, written(lab, plate, DimensionType::aligned, {3, 4}), 1, 1e-15)};
}

// Angles are written to the hundredth of a degree.
Measured small_angle(const Lab& lab, double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  const Shape wedge = prism({{0, 0}, {1, 0}, {std::cos(a), std::sin(a)}}, 1);
  return {length("text", degrees, written(lab, wedge, DimensionType::angular, {0, 1, 2}), 1, 0.005)};
}

Measured side_far_away(const Lab& lab, double offset) {
  const Shape cube = box({offset, offset, 0}, {offset + 1, offset + 1, 1});
  Quantity text = length("text", 1, written(lab, cube, DimensionType::aligned, {0, 1}), 1, 1e-15);
  text.rounding = offset * 0x1p-52;
  return {text};
}

// The radius of an arc that turns by little, from its nine vertices, whose places are known to 2^-53.
Measured flat_arc(const Lab& lab, double degrees) {
  constexpr int steps = 8;
  const double sweep = degrees * std::numbers::pi / 180;
  std::vector<Vec2> outline;
  for (int i = 0; i <= steps; ++i) {
    const double a = sweep * (double(i) / steps - 0.5);
    outline.emplace_back(std::cos(a), std::sin(a));
  }
  outline.emplace_back(0, outline.back().y);
  outline.emplace_back(0, outline.front().y);
  Quantity text = length("text", 1, written(lab, prism(outline, 1), DimensionType::radius, {4}), 1);
  text.rounding = 8 * 0x1p-53 / (1 - std::cos(sweep / 2));
  return {text};
}

Measured size_of_a_cube(const Lab& lab, double size) {
  const Shape cube = box({0, 0, 0}, {size, size, size});
  return {
      length("text", size, written(lab, cube, DimensionType::aligned, {0, 1}), size, std::max(1e-15, 1e-15 / size))};
}

}  // namespace

std::vector<Case> dimension_cases() {
  return {
      {"D1", "length of a small step", "size of the step", {0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-7, 1e-8}, small_step},
      {"D2", "angle between two sides", "degrees", {90, 45, 10, 3, 1, 0.3, 0.1, 0.01}, small_angle},
      {"D3", "side of a cube far from the origin", "offset", {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e8}, side_far_away},
      {"D4", "radius of a flat arc", "degrees", {120, 90, 60, 45, 30, 20, 10, 5}, flat_arc},
      {"D5", "side of a cube of any size", "size", {1, 1e3, 1e-3, 1e6, 1e-6, 1e9, 1e12, 1e15}, size_of_a_cube},
  };
}

}  // namespace epura::stability
