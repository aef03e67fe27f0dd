// SPDX-License-Identifier: Apache-2.0
#include "view/view_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura::view {

namespace {

double largest_component(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Returns 2^-k with 2^k just above half the size of the box.
double normalisation_of(const Box& scene) {
  const Vec3 half = scene.max * 0.5 - scene.min * 0.5;
  const double size = largest_component(half);
  if (!(size > 0)) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(size) - 1, -1022, 1022));
}

ViewMap parallel_map(const projection::Projection& p, ViewMap map) {
  const double slope = glm::dot(p.n, p.projector);
  const double s = p.scale;
  map.u = s * (p.u - (glm::dot(p.u, p.projector) / slope) * p.n);
  map.v = s * (p.v - (glm::dot(p.v, p.projector) / slope) * p.n);
  map.unit = s;
  map.depth_of_n = s * glm::length(p.projector) / slope;
  map.z = map.depth_of_n * p.n;
  map.w = Vec3(0);
  map.origin = map.centre;
  map.w_constant = 1;
  // The foot of c's projector on the plane, relative to the plane's point.
  const Vec3 l = map.centre * map.normalisation - p.point * map.normalisation;
  map.image = {glm::dot(map.u, l), glm::dot(map.v, l)};
  map.depth_to_one = 0;
  return map;
}

// A reference point well in front of the centre: the middle of the scene, or, if that lies beside or behind the viewer,
// a point straight ahead at a distance of the scene's size.
Vec3 reference_point(const projection::Projection& p, const Box& scene) {
  if (scene.empty()) return p.point;
  const Vec3 middle = scene.centre();
  const double ahead = glm::dot(p.n, p.projector - middle);
  const double size = std::max(largest_component(scene.size()), largest_component(p.projector - middle) * 0x1p-20);
  if (ahead > size * 0x1p-4) return middle;
  return p.projector - p.n * size;
}

ViewMap central_map(const projection::Projection& p, const Box& scene, ViewMap map) {
  map.centre = reference_point(p, scene);
  const Vec3 from_eye = map.centre * map.normalisation - p.projector * map.normalisation;
  const double w0 = -glm::dot(p.n, from_eye);
  const double d = glm::dot(p.n, p.projector * map.normalisation - p.point * map.normalisation);
  check(w0 > 0 && d > 0, "the reference point and the plane lie in front of the viewer");
  const double enlarge = p.scale * (d / w0);
  const double a = glm::dot(p.u, from_eye);
  const double b = glm::dot(p.v, from_eye);
  // A centre close to the scene, in comparison with its size, is the better origin: differences to it are exact.
  const bool near = largest_component({w0, a, b}) < 8 * largest_component(scene.size()) * map.normalisation;
  map.origin = near ? p.projector : map.centre;
  map.u = enlarge * (near ? p.u : p.u + (a / w0) * p.n);
  map.v = enlarge * (near ? p.v : p.v + (b / w0) * p.n);
  map.unit = enlarge;
  map.depth_of_n = enlarge * glm::length(from_eye) / w0;
  map.z = map.depth_of_n * p.n;
  map.w = -p.n / w0;
  map.z_constant = near ? map.depth_of_n * w0 : 0;
  map.w_constant = near ? 0 : 1;
  const Vec3 foot = p.projector * map.normalisation - p.point * map.normalisation;
  map.image = p.scale * Vec2(glm::dot(p.u, foot), glm::dot(p.v, foot));
  if (!near) map.image += enlarge * Vec2(a, b);
  map.depth_to_one = 1 / (w0 * map.depth_of_n);
  return map;
}

}  // namespace

ViewMap make_view_map(const projection::Projection& projection, const Box& scene) {
  ViewMap map{};
  map.centre = scene.empty() ? Vec3(0) : scene.centre();
  map.normalisation = normalisation_of(scene);
  return projection.central ? central_map(projection, scene, map) : parallel_map(projection, map);
}

}  // namespace epura::view
