// SPDX-License-Identifier: Apache-2.0
// Small dense problems: normal equations of few unknowns, and axes of symmetric matrices.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/vec.hpp"

namespace epura {

/// Normal equations of up to ten unknowns.
class NormalEquations {
 public:
  static constexpr int max_unknowns = 10;
  using Unknowns = std::array<double, max_unknowns>;

  explicit NormalEquations(int unknowns) : unknowns_(unknowns) {}

  /// One equation: slopes . x = value.
  void add(const Unknowns& slopes, double value);

  /// The least-squares solution with the diagonal enlarged by the factor 1 + damping (Marquardt). Nothing where the
  /// matrix is not positive definite.
  [[nodiscard]] std::optional<Unknowns> solve(double damping) const;

 private:
  int unknowns_;
  std::array<std::array<double, max_unknowns>, max_unknowns> matrix_{};
  Unknowns right_{};
};

/// The unit eigenvector of the smallest eigenvalue of a symmetric matrix.
Vec3 smallest_axis(const Mat3& symmetric);

/// Two unit vectors square to a unit vector and to one another.
std::array<Vec3, 2> square_to(const Vec3& axis);

}  // namespace epura
