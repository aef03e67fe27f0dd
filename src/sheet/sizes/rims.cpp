// SPDX-License-Identifier: Apache-2.0
#include "sizes/rims.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "surfaces/limits.hpp"
#include "world/placed_circles.hpp"

namespace epura::sheet {

namespace {

using surfaces::SurfaceKind;

constexpr double roundness = 2e-3;  // relative to the radius: twice the tolerance of find_circles for vertices

double distance(const Vec3& point, const WorldCircle& circle) {
  const Vec3 d = point - circle.centre;
  const double height = glm::dot(d, circle.axis);
  return std::hypot(glm::length(d - height * circle.axis) - circle.radius, height);
}

std::string text_of_radius(const Vec3& p) {
  return format_fixed(p.x, 4) + "," + format_fixed(p.y, 4) + "," + format_fixed(p.z, 4);
}

// A rim perpendicular to the axis of a shaft or bore takes its size from it: vertices of a short arc are less accurate.
void take_surface(WorldCircle& circle, const world::PlacedPart& part) {
  const double slack = roundness * circle.radius;
  double nearest = slack;
  const WorldCircle rim = circle;
  for (const surfaces::PartFace& face : part.faces) {
    const surfaces::PartSurface& surface = face.surface;
    if (surface.kind != SurfaceKind::cylinder && surface.kind != SurfaceKind::cone) continue;
    if (glm::length(glm::cross(surface.axis, rim.axis)) > roundness) continue;
    const double height = glm::dot(rim.centre - surface.origin, surface.axis);
    const Vec3 centre = surface.origin + height * surface.axis;
    const double radius = surface.radius + surface.slope * height;
    const double aside = std::max(glm::length(rim.centre - centre), std::abs(radius - rim.radius));
    if (height < face.from - slack || height > face.to + slack || aside >= nearest) continue;
    nearest = aside;
    circle.centre = centre;
    circle.radius = radius;
  }
}

/// Vertices in order of their angles around an axis, beginning after the largest gap.
std::vector<Vec3> in_order_around(const std::vector<Vec3>& points, const surfaces::PartSurface& surface) {
  const Vec3 aside = std::abs(surface.axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = glm::normalize(glm::cross(surface.axis, aside)), v = glm::cross(surface.axis, u);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 d = points[i] - surface.origin;
    order.emplace_back(portable_atan2(glm::dot(d, v), glm::dot(d, u)), i);
  }
  std::sort(order.begin(), order.end());
  std::size_t first = 0;
  double largest = order.front().first + 2 * std::numbers::pi - order.back().first;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (const double gap = order[i].first - order[i - 1].first; gap > largest) {
      largest = gap;
      first = i;
    }
  check(largest * static_cast<double>(order.size()) >= 2 * std::numbers::pi * (1 - 1e-9), "the gaps are a whole turn");
  std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
  std::vector<Vec3> sorted;
  for (const auto& [angle, i] : order) sorted.push_back(points[i]);
  return sorted;
}

}  // namespace

Rims::Model& Rims::of_model(int model) {
  const auto [at, first_time] = models_.try_emplace(model);
  if (!first_time) return at->second;
  at->second.part = world::place_part(world_.models[model]);
  for (const mesh::MeshCircle& circle : world::find_circles(world_, model)) {
    WorldCircle placed{circle.centre, circle.axis, circle.radius, {}, circle.whole};
    for (const int v : circle.vertices) placed.rim.push_back(world_.points[world_.first_vertex[model] + v]);
    if (at->second.part) take_surface(placed, *at->second.part);
    at->second.rims.push_back({circle.vertices, std::move(placed)});
  }
  return at->second;
}

std::vector<WorldCircle> Rims::of_faces(const std::array<int, 2>& vertex) {
  const auto [model, number] = vertex;
  const std::optional<world::PlacedPart>& part = of_model(model).part;
  if (!part) return {};
  const int first = world_.first_triangle[model], last = world_.first_triangle[model + 1];
  const int wanted = world_.first_vertex[model] + number;
  std::set<int> faces;
  for (int t = first; t < last; ++t) {
    const int face = part->face_of_triangle[t - first];
    const auto& corners = world_.triangles[t];
    if (face >= 0 && part->faces[face].surface.kind == SurfaceKind::cylinder &&
        std::find(corners.begin(), corners.end(), wanted) != corners.end())
      faces.insert(face);
  }
  std::vector<WorldCircle> circles;
  for (const int face : faces) {
    std::vector<Vec3> points;
    for (int t = first; t < last; ++t)
      if (part->face_of_triangle[t - first] == face)
        for (const int v : world_.triangles[t]) points.push_back(world_.points[v]);
    const surfaces::PartSurface& surface = part->faces[face].surface;
    check(surface.radius > 0 && points.size() >= 3, "a cylinder has a radius and triangles");
    const double height = glm::dot(world_.points[wanted] - surface.origin, surface.axis);
    circles.push_back({surface.origin + height * surface.axis, surface.axis, surface.radius,
                       in_order_around(points, surface), part->faces[face].sweep >= surfaces::whole_turn});
  }
  return circles;
}

std::vector<WorldCircle> Rims::through(const scene::Anchor& anchor, const Vec3& place, const std::string& where) {
  const auto* vertex = std::get_if<std::array<int, 2>>(&anchor);
  const int first = vertex ? (*vertex)[0] : 0;
  const int last = vertex ? first : static_cast<int>(world_.models.size()) - 1;
  check(first >= 0 && last < static_cast<int>(world_.models.size()), "an anchor is of a model of the world");
  std::vector<WorldCircle> circles;
  const Rim* nearest = nullptr;
  for (int model = first; model <= last; ++model) {
    for (const Rim& rim : of_model(model).rims) {
      const bool on_it = vertex ? std::count(rim.vertices.begin(), rim.vertices.end(), (*vertex)[1]) > 0
                                : distance(place, rim.circle) <= roundness * rim.circle.radius;
      if (on_it) circles.push_back(rim.circle);
      if (!nearest || distance(place, rim.circle) < distance(place, nearest->circle)) nearest = &rim;
    }
  }
  if (circles.empty() && vertex != nullptr) circles = of_faces(*vertex);
  if (!circles.empty()) return circles;
  throw Error(ErrorKind::input, where,
              "needs a vertex on the rim of a circle, and there is none at " + text_of_radius(place),
              nearest ? "the nearest circle has radius " + format_rounded(nearest->circle.radius, 6) + " around " +
                            text_of_radius(nearest->circle.centre) + "; for example, use its vertex " +
                            std::to_string(nearest->vertices.front())
                      : "no circle was found: rims of holes, bosses and shafts are circles");
}

}  // namespace epura::sheet
