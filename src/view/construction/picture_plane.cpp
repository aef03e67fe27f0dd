// SPDX-License-Identifier: Apache-2.0
#include "construction/picture_plane.hpp"

#include <cmath>

namespace epura::construction {

namespace {

// As in projection/matrices.cpp: a vanishing point at a distance of 1e12 eye distances is on no page.
constexpr double parallel_cosine = 1e-12;

Vec2 in_plane(const PicturePlane& plane, const Vec3& direction) {
  return {glm::dot(direction, plane.u), glm::dot(direction, plane.v)};
}

// The line g . p = c, where p is counted from the origin.
std::optional<PictureLine> line_of(const PicturePlane& plane, const Vec2& g, double c) {
  const double length = glm::length(g);
  if (!(length > parallel_cosine)) return std::nullopt;
  return PictureLine{plane.origin + g * (c / (length * length)), Vec2(g.y, -g.x) / length};
}

}  // namespace

PicturePlane picture_plane(const projection::Projection& projection, const Mat4& world_to_page, double scale) {
  PicturePlane plane{projection.central, projection.u, projection.v, projection.n, projection.projector};
  plane.scale = scale * projection.scale;
  plane.world_to_page = world_to_page;
  plane.foot = projection.point;
  Vec4 image = world_to_page * Vec4(projection.point, 1);
  if (plane.central) {
    const double distance = glm::dot(projection.projector - projection.point, projection.n);
    plane.eye = distance * plane.scale;
    plane.foot = projection.projector - distance * projection.n;
    // Lines along the normal vanish at its foot, which may be far from the scene.
    image = world_to_page * Vec4(projection.n, 0);
  }
  plane.origin = Vec2(image) / image.w;
  return plane;
}

std::optional<Vec2> image_of(const PicturePlane& plane, const Vec3& point) {
  const Vec4 image = plane.world_to_page * Vec4(point, 1);
  if (!(image.w > 0)) return std::nullopt;
  return Vec2(image) / image.w;
}

std::optional<Vec2> vanishing_point(const PicturePlane& plane, const Vec3& direction) {
  const Vec3 d = glm::normalize(direction);
  const double cosine = glm::dot(d, plane.n);
  if (!plane.central || std::abs(cosine) <= parallel_cosine) return std::nullopt;
  return plane.origin - in_plane(plane, d) * (plane.eye / cosine);
}

// A point p of the picture is the image of the direction p.x u + p.y v - e n.
std::optional<PictureLine> vanishing_line(const PicturePlane& plane, const Vec3& normal) {
  if (!plane.central) return std::nullopt;
  const Vec3 m = glm::normalize(normal);
  return line_of(plane, in_plane(plane, m), plane.eye * glm::dot(m, plane.n));
}

std::optional<PictureLine> trace_of_plane(const PicturePlane& plane, const Vec3& point, const Vec3& normal) {
  const Vec3 m = glm::normalize(normal);
  return line_of(plane, in_plane(plane, m), plane.scale * glm::dot(m, point - plane.foot));
}

std::optional<Vec2> trace_of_line(const PicturePlane& plane, const Vec3& from, const Vec3& to) {
  const Vec3 d = glm::normalize(to - from);
  const double cosine = glm::dot(d, plane.n);
  if (std::abs(cosine) <= parallel_cosine) return std::nullopt;
  const Vec3 at = from - plane.foot - d * (glm::dot(from - plane.foot, plane.n) / cosine);
  return plane.origin + in_plane(plane, at) * plane.scale;
}

std::array<Vec2, 3> axis_images(const PicturePlane& plane, double length_in_plane) {
  const Vec2 slope = in_plane(plane, plane.projector) / glm::dot(plane.projector, plane.n);
  std::array<Vec2, 3> images{};
  for (int i = 0; i < 3; ++i)
    images[static_cast<std::size_t>(i)] = length_in_plane * (Vec2(plane.u[i], plane.v[i]) - slope * plane.n[i]);
  return images;
}

}  // namespace epura::construction
