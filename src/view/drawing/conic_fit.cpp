// SPDX-License-Identifier: Apache-2.0
#include "drawing/conic_fit.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

using Mat2 = glm::dmat2;
using Column = std::vector<double>;

double dot(const Column& a, const Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Least squares by modified Gram-Schmidt: the coefficients with which `columns` come nearest to `target`.
template <std::size_t n>
std::optional<std::array<double, n>> least_squares(std::array<Column, n> columns, Column target) {
  std::array<std::array<double, n + 1>, n> r{};
  const double before = dot(target, target);
  for (std::size_t j = 0; j < n; ++j) {
    r[j][j] = std::sqrt(dot(columns[j], columns[j]));
    if (!(r[j][j] > 1e-12 * std::sqrt(static_cast<double>(target.size())))) return std::nullopt;
    for (double& x : columns[j]) x /= r[j][j];
    for (std::size_t k = j + 1; k <= n; ++k) {
      Column& column = k < n ? columns[k] : target;
      r[j][k] = dot(columns[j], column);
      for (std::size_t i = 0; i < column.size(); ++i) column[i] -= r[j][k] * columns[j][i];
    }
  }
  check(!(dot(target, target) > before * (1 + rounding_part)), "a fit leaves no more than there was");
  std::array<double, n> result{};
  for (std::size_t j = n; j-- > 0;) {
    result[j] = r[j][n];
    for (std::size_t k = j + 1; k < n; ++k) result[j] -= r[j][k] * result[k];
    result[j] /= r[j][j];
  }
  return result;
}

// An affine map of points, p -> matrix (p - middle).
struct Whitening {
  Vec2 middle;
  Mat2 matrix;
};

std::optional<Whitening> whiten(std::span<const Vec2> points) {
  const auto count = static_cast<double>(points.size());
  Vec2 middle(0);
  for (const Vec2& p : points) middle += p / count;
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2& p : points) {
    const Vec2 d = p - middle;
    xx += d.x * d.x / count;
    xy += d.x * d.y / count;
    yy += d.y * d.y / count;
  }
  // The inverse of the Cholesky factor of the covariance.
  if (!(xx > 0)) return std::nullopt;
  const double a = std::sqrt(xx), b = xy / a, c2 = yy - b * b;
  if (!(c2 > 1e-12 * (xx + yy))) return std::nullopt;
  const double c = std::sqrt(c2);
  return Whitening{middle, Mat2(Vec2(1 / a, -b / (a * c)), Vec2(0, 1 / c))};
}

// The ellipse x' matrix x = 1 around the centre.
std::optional<Ellipse> from_matrix(const Vec2& centre, const Mat2& matrix) {
  const double half_trace = (matrix[0][0] + matrix[1][1]) / 2, half_difference = (matrix[0][0] - matrix[1][1]) / 2;
  const double off = matrix[0][1];
  const double radius = std::hypot(half_difference, off);
  const double min = half_trace - radius, max = half_trace + radius;
  if (!(min > 0) || !std::isfinite(max)) return std::nullopt;
  // The direction of the larger eigenvalue is that of the semi-minor axis.
  const double angle = portable_atan2(off, half_difference) / 2;
  const Vec2 minor(portable_cos(angle), portable_sin(angle));
  return Ellipse{centre, Vec2(minor.y, -minor.x) / std::sqrt(min), minor / std::sqrt(max)};
}

}  // namespace

double Ellipse::distance(const Vec2& p) const {
  const Vec2 d = p - centre;
  const double x = glm::dot(d, u) / glm::dot(u, u), y = glm::dot(d, v) / glm::dot(v, v);
  const Vec2 gradient = 2.0 * (x / glm::length(u) * glm::normalize(u) + y / glm::length(v) * glm::normalize(v));
  return std::abs(x * x + y * y - 1) / glm::length(gradient);
}

std::optional<Ellipse> fit_ellipse(std::span<const Vec2> points) {
  if (points.size() < 5) return std::nullopt;
  const auto white = whiten(points);
  if (!white) return std::nullopt;
  // y^2 + a (x^2 - y^2) + b x y + d x + e y - f = 0
  std::array<Column, 5> columns;
  Column target;
  for (const Vec2& point : points) {
    const Vec2 p = white->matrix * (point - white->middle);
    const std::array<double, 5> row{p.x * p.x - p.y * p.y, p.x * p.y, p.x, p.y, -1};
    for (std::size_t j = 0; j < 5; ++j) columns[j].push_back(row[j]);
    target.push_back(-p.y * p.y);
  }
  const auto solved = least_squares(std::move(columns), std::move(target));
  if (!solved) return std::nullopt;
  const auto [a, b, d, e, f] = *solved;
  const Mat2 conic(Vec2(a, b / 2), Vec2(b / 2, 1 - a));
  if (!(glm::determinant(conic) > 0)) return std::nullopt;
  const Vec2 centre = glm::inverse(conic) * Vec2(-d / 2, -e / 2);
  const double level = f + glm::dot(centre, conic * centre);
  if (!(level > 0)) return std::nullopt;
  const Mat2 matrix = glm::transpose(white->matrix) * conic * white->matrix;
  const auto ellipse = from_matrix(white->middle + glm::inverse(white->matrix) * centre, matrix * (1 / level));
  check(!ellipse || glm::dot(ellipse->u, ellipse->u) >= glm::dot(ellipse->v, ellipse->v),
        "the longer axis comes first");
  return ellipse;
}

}  // namespace epura::drawing
