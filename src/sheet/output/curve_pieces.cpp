// SPDX-License-Identifier: Apache-2.0
#include "output/curve_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing/curve_part.hpp"

namespace epura::output {

namespace {

constexpr double quarter = std::numbers::pi / 2;

int pieces_of(const drawing::CurvePart& curve, double longest) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(curve.to - curve.from) / longest - 1e-9)));
}

}  // namespace

std::vector<BezierPiece> bezier_pieces(const drawing::CurvePart& curve, double tolerance) {
  constexpr double error_of_quarter = 2.73e-4;
  const double radius = std::max(glm::length(curve.u), glm::length(curve.v));
  const double longest = quarter * std::min(1.0, std::pow(tolerance / (error_of_quarter * radius), 1.0 / 6));
  const int count = pieces_of(curve, longest);
  const double step = (curve.to - curve.from) / count, reach = 4.0 / 3 * std::tan(step / 4);
  const auto tangent = [&](double a) { return std::cos(a) * curve.v - std::sin(a) * curve.u; };
  std::vector<BezierPiece> pieces;
  for (int i = 0; i < count; ++i) {
    const double a = curve.from + i * step, b = a + step;
    const Vec2 from = drawing::position_on_curve(curve, a), to = drawing::position_on_curve(curve, b);
    pieces.push_back({{from + reach * tangent(a), to - reach * tangent(b)}, to});
  }
  return pieces;
}

std::vector<Vec2> quarter_ends(const drawing::CurvePart& curve) {
  const int count = pieces_of(curve, quarter);
  std::vector<Vec2> ends;
  for (int i = 1; i <= count; ++i)
    ends.push_back(drawing::position_on_curve(curve, curve.from + (curve.to - curve.from) * i / count));
  return ends;
}

}  // namespace epura::output
