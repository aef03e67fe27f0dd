// SPDX-License-Identifier: Apache-2.0
#include "annotations/seen_circle.hpp"

#include <algorithm>
#include <cmath>

#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double on_rim = 0.01;  // relative to the radius

}  // namespace

double SeenCircle::radius() const { return std::max(glm::length(u), glm::length(v)); }

bool SeenCircle::is_round() const {
  const double slack = 1e-4 * glm::dot(u, u);
  return slack > 0 && std::abs(glm::dot(u, u) - glm::dot(v, v)) <= slack && std::abs(glm::dot(u, v)) <= slack;
}

bool SeenCircle::is_slanted() const { return glm::length(axis) > edge_on * radius(); }

bool SeenCircle::is_edge_on() const { return is_slanted() && reach(axis / glm::length(axis)) <= edge_on * radius(); }

Vec2 SeenCircle::local(const Vec2& p) const {
  const Vec2 d = p - centre;
  return Vec2(cross(d, v), cross(u, d)) / cross(u, v);
}

bool SeenCircle::has(const Vec2& p) const { return std::abs(glm::length(local(p)) - 1) <= on_rim; }

double SeenCircle::angle_between(const Vec2& p, const Vec2& q) const {
  const Vec2 a = local(p), b = local(q);
  return portable_atan2(cross(a, b), glm::dot(a, b));
}

double SeenCircle::reach(const Vec2& direction) const {
  return std::hypot(glm::dot(u, direction), glm::dot(v, direction));
}

Vec2 image_of(const drawing::ViewDrawing& drawing, const Vec3& p, double w) {
  const Vec4 image = drawing.world_to_page * Vec4(p, w);
  return Vec2(image.x, image.y) / drawing.world_to_page[3][3];
}

SeenCircle see(const drawing::ViewDrawing& drawing, const Vec3& axis, const features::Ring& ring) {
  const Vec3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  return {image_of(drawing, ring.centre, 1), image_of(drawing, ring.radius * u, 0),
          image_of(drawing, ring.radius * glm::cross(axis, u), 0), image_of(drawing, ring.radius * axis, 0)};
}

std::vector<SeenCircle> see(const drawing::ViewDrawing& drawing, const features::CentredRound& feature) {
  std::vector<SeenCircle> circles;
  for (const features::Ring& ring : feature.rings) circles.push_back(see(drawing, feature.axis, ring));
  return circles;
}

const SeenCircle& largest_of(std::span<const SeenCircle> circles) {
  return *std::max_element(circles.begin(), circles.end(),
                           [](const SeenCircle& a, const SeenCircle& b) { return a.radius() < b.radius(); });
}

}  // namespace epura::sheet
