// SPDX-License-Identifier: Apache-2.0
// Small dense problems: normal equations with few unknowns, and axes of symmetric matrices.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "base/vec.hpp"

namespace epura::surfaces {

/// Normal equations with `size` unknowns.
template <int size>
class NormalEquations {
 public:
  using Unknowns = std::array<double, size>;

  /// Adds one equation: slopes . x = value.
  void add(const Unknowns& slopes, double value) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j <= i; ++j) matrix_[i][j] += slopes[i] * slopes[j];
      right_[i] += slopes[i] * value;
    }
  }

  /// Returns the least-squares solution with the diagonal enlarged by the factor 1 + damping (Marquardt), or nothing if
  /// the matrix is not positive definite.
  [[nodiscard]] std::optional<Unknowns> solve(double damping) const {
    auto lower = matrix_;
    double largest = 0;
    for (int i = 0; i < size; ++i) largest = std::max(largest, matrix_[i][i]);
    // A small fraction of the largest entry fixes unknowns that the equations do not determine.
    for (int i = 0; i < size; ++i) lower[i][i] += damping * matrix_[i][i] + 1e-14 * largest;
    if (!decompose(lower)) return std::nullopt;
    Unknowns x = right_;
    for (int i = 0; i < size; ++i) {
      for (int k = 0; k < i; ++k) x[i] -= lower[i][k] * x[k];
      x[i] /= lower[i][i];
    }
    for (int i = size - 1; i >= 0; --i) {
      for (int k = i + 1; k < size; ++k) x[i] -= lower[k][i] * x[k];
      x[i] /= lower[i][i];
    }
    return x;
  }

 private:
  using Matrix = std::array<std::array<double, size>, size>;

  // Cholesky decomposition in place.
  static bool decompose(Matrix& lower) {
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < j; ++k) lower[j][j] -= lower[j][k] * lower[j][k];
      if (!(lower[j][j] > 0)) return false;
      lower[j][j] = std::sqrt(lower[j][j]);
      for (int i = j + 1; i < size; ++i) {
        for (int k = 0; k < j; ++k) lower[i][j] -= lower[i][k] * lower[j][k];
        lower[i][j] /= lower[j][j];
      }
    }
    return true;
  }

  Matrix matrix_{};
  Unknowns right_{};
};

/// Returns the mean of one or more points.
Vec3 mean_of(std::span<const Vec3> points);

/// Returns the unit eigenvector of the smallest eigenvalue of a symmetric matrix.
Vec3 smallest_axis(const Mat3& symmetric);

/// Returns two unit vectors that are perpendicular to a unit vector and to each other.
std::array<Vec3, 2> square_to(const Vec3& axis);

}  // namespace epura::surfaces
