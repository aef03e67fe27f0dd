// SPDX-License-Identifier: Apache-2.0
#include "scene/transform.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"

namespace epura::scene {

namespace {

[[noreturn]] void refuse(std::string_view step, const std::string& reason) {
  throw Error(ErrorKind::input, "transform '" + std::string(step) + "'", reason,
              "steps: translate:X,Y,Z  rotate:x|y|z,DEGREES  scale:S or scale:X,Y,Z  matrix:16 numbers");
}

// Quarter turns are exact, without a negative zero, so that a rotated box remains a box.
Mat4 rotation(const Vec3& axis, double degrees) {
  const double turned = std::remainder(degrees, 360.0), radians = turned * std::numbers::pi / 180;
  const bool quarters = std::remainder(turned, 90.0) == 0;
  const double c = quarters ? std::round(portable_cos(radians)) + 0.0 : portable_cos(radians);
  const double s = quarters ? std::round(portable_sin(radians)) + 0.0 : portable_sin(radians);
  Mat4 matrix(1.0);
  const int i = axis.x != 0 ? 1 : axis.y != 0 ? 2 : 0;
  const int j = (i + 1) % 3;
  matrix[i][i] = c;
  matrix[j][j] = c;
  matrix[i][j] = s;
  matrix[j][i] = -s;
  return matrix;
}

Mat4 rotation_step(std::string_view step, std::string_view values) {
  const auto parts = split(values, ',');
  const auto degrees = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  if (!degrees || !std::isfinite(*degrees)) refuse(step, "needs an axis and an angle in degrees");
  if (parts[0] == "x") return rotation({1, 0, 0}, *degrees);
  if (parts[0] == "y") return rotation({0, 1, 0}, *degrees);
  if (parts[0] == "z") return rotation({0, 0, 1}, *degrees);
  refuse(step, "has an unknown axis '" + std::string(parts[0]) + "'");
}

Mat4 parse_step(std::string_view step) {
  const std::size_t colon = step.find(':');
  const std::string_view verb = step.substr(0, colon);
  const std::string_view values = colon == std::string_view::npos ? std::string_view{} : step.substr(colon + 1);
  if (verb == "rotate") return rotation_step(step, values);
  if (verb != "translate" && verb != "scale" && verb != "matrix") refuse(step, "is not a known step");

  const auto numbers = parse_numbers(values);
  if (!numbers) refuse(step, "needs numbers separated by commas");
  for (const double number : *numbers) {
    if (!std::isfinite(number)) refuse(step, "has a number that is not finite");
    if (!is_usable(number)) refuse(step, "has a number beyond " + format_number(largest_number));
  }
  const std::vector<double>& v = *numbers;
  if (verb == "translate" && v.size() == 3) return glm::translate(Mat4(1.0), Vec3(v[0], v[1], v[2]));
  if (verb == "scale" && v.size() == 1) return glm::scale(Mat4(1.0), Vec3(v[0]));
  if (verb == "scale" && v.size() == 3) return glm::scale(Mat4(1.0), Vec3(v[0], v[1], v[2]));
  if (verb == "matrix" && v.size() == 16)
    return rows({v[0], v[1], v[2], v[3]}, {v[4], v[5], v[6], v[7]}, {v[8], v[9], v[10], v[11]},
                {v[12], v[13], v[14], v[15]});
  refuse(step, "has the wrong number of values");
}

// Scaled first: the determinant of a small matrix would vanish.
bool is_flat(const Mat3& matrix) {
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(matrix[i / 3][i % 3]));
  return largest == 0 || glm::determinant(matrix / largest) == 0;
}

}  // namespace

Mat4 parse_transform(std::string_view text) {
  Mat4 matrix(1.0);
  for (const std::string_view step : split(text, ' ')) {
    if (step.empty()) continue;
    matrix = parse_step(step) * matrix;
    if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1)
      refuse(step, "is not affine: the last row must be 0,0,0,1");
    if (is_flat(Mat3(matrix))) refuse(step, "flattens the model");
  }
  return matrix;
}

Mat4 y_up_to_z_up() { return rotation({1, 0, 0}, 90); }

}  // namespace epura::scene
