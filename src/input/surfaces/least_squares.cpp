// SPDX-License-Identifier: Apache-2.0
#include "surfaces/least_squares.hpp"

namespace epura::surfaces {

// Jacobi rotations.
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

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum(0);
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

std::array<Vec3, 2> square_to(const Vec3& axis) {
  const Vec3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  return {u, glm::cross(axis, u)};
}

}  // namespace epura::surfaces
