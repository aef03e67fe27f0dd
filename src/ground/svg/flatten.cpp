// SPDX-License-Identifier: Apache-2.0
#include "svg/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace epura::svg {

int parts_of_curve(double sagitta) {
  constexpr double flatness = 1e-4;
  constexpr int max = 10000;
  const double parts = std::ceil(std::sqrt(sagitta / flatness));
  return parts < max ? std::max(static_cast<int>(parts), 1) : max;  // also if NaN: the curve is beyond all paper
}

void append_cubic(std::vector<Vec2>& points, const CubicCurve& curve, PieceRoom& room) {
  const auto& [from, a, b, to] = curve;
  const double bend = std::max(glm::length(from - 2.0 * a + b), glm::length(a - 2.0 * b + to));
  const int parts = parts_of_curve(0.75 * bend);
  room.take(static_cast<std::size_t>(parts));
  for (int i = 1; i < parts; ++i) {
    const double t = double(i) / parts, s = 1 - t;
    points.push_back(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
  }
  points.push_back(to);
}

namespace {

constexpr std::size_t always_room = 250'000;

}  // namespace

PieceRoom::PieceRoom(std::size_t bytes, std::string where)
    : where_(std::move(where)), max_(always_room + bytes / 2), left_(max_) {}

void PieceRoom::take(std::size_t pieces) {
  if (pieces > left_)
    throw Error(ErrorKind::input, where_, "stands for more than " + std::to_string(max_) + " pieces of lines",
                "a drawing of this file size has fewer");
  left_ -= pieces;
}

}  // namespace epura::svg
