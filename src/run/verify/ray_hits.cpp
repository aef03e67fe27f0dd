// SPDX-License-Identifier: Apache-2.0
#include "verify/ray_hits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"

namespace epura::verify {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

// Enough to halve any interval of doubles of one magnitude down to neighbours.
constexpr int halvings_of_root = 80;

double value_at(std::span<const double> c, double x) {
  double value = 0;
  for (std::size_t i = c.size(); i-- > 0;) value = value * x + c[i];
  return value;
}

// Cauchy's bound: no zero is farther from 0.
double bound_of(std::span<const double> c) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) largest = std::max(largest, std::abs(c[i] / c.back()));
  return 1 + largest;
}

double between(std::span<const double> c, double low, double high) {
  const bool rises = value_at(c, high) > 0;
  for (int i = 0; i < halvings_of_root; ++i) {
    const double middle = 0.5 * (low + high);
    ((value_at(c, middle) > 0) == rises ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

// Coefficients along the line of the polynomials below, with p = a + s b from the origin of the surface.
struct Along {
  double aa, ab;  ///< a.a, a.b
  double ha, hb;  ///< a and b along the axis
};

std::vector<double> polynomial_of(const PartSurface& surface, const Along& line) {
  const auto [aa, ab, ha, hb] = line;
  const double r = surface.radius;
  switch (surface.kind) {
    case SurfaceKind::plane:
      return {ha, hb};
    case SurfaceKind::sphere:
      return {aa - r * r, 2 * ab, 1};
    case SurfaceKind::cylinder:
      return {aa - ha * ha - r * r, 2 * (ab - ha * hb), 1 - hb * hb};
    case SurfaceKind::cone: {
      const double k = surface.slope, at = r + k * ha, grows = k * hb;
      return {aa - ha * ha - at * at, 2 * (ab - ha * hb - at * grows), 1 - hb * hb - grows * grows};
    }
    case SurfaceKind::torus: {
      // (p.p + R^2 - r^2)^2 = 4 R^2 (p.p - h^2)
      const double k = aa + r * r - surface.minor * surface.minor, f = 4 * r * r;
      return {k * k - f * (aa - ha * ha), 4 * ab * k - 2 * f * (ab - ha * hb), 2 * k + 4 * ab * ab - f * (1 - hb * hb),
              4 * ab, 1};
    }
    case SurfaceKind::free_form:
      break;
  }
  return {};
}

}  // namespace

std::vector<double> sign_changes(std::span<const double> coefficients) {
  while (!coefficients.empty() && coefficients.back() == 0) coefficients = coefficients.first(coefficients.size() - 1);
  if (coefficients.size() < 2) return {};
  std::vector<double> derivative;
  for (std::size_t i = 1; i < coefficients.size(); ++i) derivative.push_back(static_cast<double>(i) * coefficients[i]);
  // Between its extremes, a polynomial rises or falls.
  std::vector<double> ends = sign_changes(derivative), found;
  const double bound = bound_of(coefficients);
  ends.insert(ends.begin(), -bound);
  ends.push_back(bound);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if ((value_at(coefficients, ends[i]) > 0) != (value_at(coefficients, ends[i + 1]) > 0))
      found.push_back(between(coefficients, ends[i], ends[i + 1]));
  return found;
}

std::vector<double> ray_hits(const PartSurface& surface, const Ray& ray) {
  // From the place nearest to the origin of the surface, in units of its size, so that the numbers are near 1.
  const double size = surface.radius + surface.minor, unit = size > 0 ? size : 1;
  const double nearest = glm::dot(surface.origin - ray.from, ray.along);
  const Vec3 a = (ray.from + nearest * ray.along - surface.origin) / unit;
  PartSurface scaled = surface;
  scaled.radius /= unit;
  scaled.minor /= unit;
  const Along line{glm::dot(a, a), glm::dot(a, ray.along), glm::dot(a, surface.axis),
                   glm::dot(ray.along, surface.axis)};
  std::vector<double> hits = sign_changes(polynomial_of(scaled, line));
  if (surface.kind == SurfaceKind::cone)
    std::erase_if(hits, [&](double s) { return scaled.radius + scaled.slope * (line.ha + s * line.hb) < 0; });
  for (double& hit : hits) hit = nearest + unit * hit;
  return hits;
}

Vec3 normal_on(const PartSurface& surface, const Vec3& point) {
  const Vec3 p = point - surface.origin;
  const double height = glm::dot(p, surface.axis);
  const Vec3 beside = p - height * surface.axis;
  const double radius = glm::length(beside);
  Vec3 normal(0);
  switch (surface.kind) {
    case SurfaceKind::plane:
      return surface.axis;
    case SurfaceKind::sphere:
      normal = p;
      break;
    case SurfaceKind::cylinder:
      normal = beside;
      break;
    case SurfaceKind::cone:
      normal = beside - surface.slope * radius * surface.axis;
      break;
    case SurfaceKind::torus:
      if (radius > 0) normal = p - surface.radius / radius * beside;
      break;
    case SurfaceKind::free_form:
      break;
  }
  const double length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0);
}

double angle_between_planes(const Vec3& a, const Vec3& b) {
  return degrees * std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b)));
}

}  // namespace epura::verify
