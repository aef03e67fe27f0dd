// SPDX-License-Identifier: Apache-2.0
#include "features/least_squares.hpp"

#include <algorithm>

namespace epura {

void NormalEquations::add(const Unknowns& slopes, double value) {
  for (int i = 0; i < unknowns_; ++i) {
    for (int j = 0; j <= i; ++j) matrix_[i][j] += slopes[i] * slopes[j];
    right_[i] += slopes[i] * value;
  }
}

std::optional<NormalEquations::Unknowns> NormalEquations::solve(double damping) const {
  auto lower = matrix_;
  double largest = 0;
  for (int i = 0; i < unknowns_; ++i) largest = std::max(largest, matrix_[i][i]);
  // Cholesky. What the equations do not determine is held by a little of the largest entry.
  for (int i = 0; i < unknowns_; ++i) lower[i][i] += damping * matrix_[i][i] + 1e-14 * largest;
  for (int j = 0; j < unknowns_; ++j) {
    for (int k = 0; k < j; ++k) lower[j][j] -= lower[j][k] * lower[j][k];
    if (!(lower[j][j] > 0)) return std::nullopt;
    lower[j][j] = std::sqrt(lower[j][j]);
    for (int i = j + 1; i < unknowns_; ++i) {
      for (int k = 0; k < j; ++k) lower[i][j] -= lower[i][k] * lower[j][k];
      lower[i][j] /= lower[j][j];
    }
  }
  Unknowns x = right_;
  for (int i = 0; i < unknowns_; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= lower[i][k] * x[k];
    x[i] /= lower[i][i];
  }
  for (int i = unknowns_ - 1; i >= 0; --i) {
    for (int k = i + 1; k < unknowns_; ++k) x[i] -= lower[k][i] * x[k];
    x[i] /= lower[i][i];
  }
  return x;
}

// Jacobi's rotations.
Vec3 smallest_axis(const Mat3& symmetric) {
  Mat3 a = symmetric;
  Mat3 axes(1);
  for (int sweep = 0; sweep < 12; ++sweep) {
    const double off = a[1][0] * a[1][0] + a[2][0] * a[2][0] + a[2][1] * a[2][1];
    const double on = a[0][0] * a[0][0] + a[1][1] * a[1][1] + a[2][2] * a[2][2];
    if (!(off > 1e-34 * on)) break;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[q][p] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[q][p]);
        const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        Mat3 turn(1);
        turn[p][p] = turn[q][q] = c;
        turn[q][p] = s;
        turn[p][q] = -s;
        a = glm::transpose(turn) * a * turn;
        axes = axes * turn;
      }
  }
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (a[i][i] < a[least][least]) least = i;
  return glm::normalize(axes[least]);
}

std::array<Vec3, 2> square_to(const Vec3& axis) {
  const Vec3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  return {u, glm::cross(axis, u)};
}

}  // namespace epura
