// SPDX-License-Identifier: Apache-2.0
#include "surfaces/holes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/nearest.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

class HoleFinder {
 public:
  HoleFinder(const mesh::Mesh& mesh, const PartFaces& part)
      : mesh_(mesh), part_(part), beside_(part.faces.size()), used_(part.faces.size()) {
    for (const PartBorder& border : part.borders)
      if (border.faces[0] >= 0 && border.faces[0] != border.faces[1]) {
        beside_[border.faces[0]].push_back(border.faces[1]);
        beside_[border.faces[1]].push_back(border.faces[0]);
      }
    for (auto& faces : beside_) {
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    triangles_.resize(part.faces.size());
    for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t)
      if (part.face_of_triangle[t] >= 0) triangles_[part.face_of_triangle[t]].push_back(static_cast<int>(t));
  }

  std::vector<Hole> find() {
    std::vector<Hole> holes;
    for (int f = 0; f < static_cast<int>(part_.faces.size()); ++f)
      if (used_[f] == 0 && is_bore(part_.faces[f])) holes.push_back(hole_around(f));
    return holes;
  }

 private:
  [[nodiscard]] static bool is_bore(const PartFace& face) {
    return face.surface.kind == SurfaceKind::cylinder && face.inwards && face.sweep >= whole_turn;
  }

  [[nodiscard]] bool is_about(const PartFace& face, const PartSurface& bore) const {
    if (!has_axis(face.surface.kind) || !face.inwards || face.sweep < whole_turn) return false;
    if (glm::length(glm::cross(face.surface.axis, bore.axis)) > told_apart_sine) return false;
    const Vec3 from = face.surface.origin - bore.origin;
    const double aside = glm::length(from - glm::dot(from, bore.axis) * bore.axis);
    return aside <= std::max(32 * part_.tolerance, 1e-4 * bore.radius);
  }

  // Faces around the axis, also across steps, which are planes perpendicular to it.
  [[nodiscard]] std::vector<int> faces_about(int bore) {
    const PartSurface& surface = part_.faces[bore].surface;
    std::vector<int> faces{bore};
    used_[bore] = 1;
    const auto take = [&](int face) {
      if (used_[face] != 0 || !is_about(part_.faces[face], surface)) return;
      used_[face] = 1;
      faces.push_back(face);
    };
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const int next : beside_[faces[i]]) {
        take(next);
        const PartSurface& step = part_.faces[next].surface;
        if (step.kind != SurfaceKind::plane) continue;
        if (glm::length(glm::cross(step.axis, surface.axis)) > told_apart_sine) continue;
        // A large face has many neighbours and is not a step.
        for (const int behind : beside_[next])
          if (part_.faces[next].area <= std::max(largest_section(faces), largest_section({behind}))) take(behind);
      }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  // Steps and bottoms of a hole are no larger than this.
  [[nodiscard]] double largest_section(const std::vector<int>& faces) const {
    double radius = 0;
    for (const int f : faces) radius = std::max(radius, part_.faces[f].surface.radius);
    return 16 * std::numbers::pi * radius * radius;
  }

  [[nodiscard]] Hole hole_around(int bore) {
    const PartSurface& surface = part_.faces[bore].surface;
    Hole hole{faces_about(bore), {}, {}, {}, true};
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (const int f : hole.faces) {
      const PartFace& face = part_.faces[f];
      const double middle = glm::dot(face.surface.origin - surface.origin, surface.axis);
      const double way = glm::dot(face.surface.axis, surface.axis) < 0 ? -1 : 1;
      for (const double height : {face.from, face.to}) {
        from = std::min(from, middle + way * height);
        to = std::max(to, middle + way * height);
      }
      if (face.surface.kind == SurfaceKind::cylinder) hole.diameters.push_back(2 * face.surface.radius);
    }
    std::sort(hole.diameters.begin(), hole.diameters.end());
    hole.from = surface.origin + from * surface.axis;
    hole.to = surface.origin + to * surface.axis;
    hole.closed = closed_ends(hole);
    hole.through = !hole.closed[0] && !hole.closed[1];
    return hole;
  }

  // At which ends a face of the hole, or one adjacent to it, crosses its axis.
  [[nodiscard]] std::array<bool, 2> closed_ends(const Hole& hole) const {
    std::vector<int> faces = hole.faces;
    for (const int f : hole.faces)
      for (const int next : beside_[f])
        if (part_.faces[next].area <= largest_section(hole.faces)) faces.push_back(next);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::array<bool, 2> closed{};
    const double length = glm::distance(hole.from, hole.to);
    for (const int f : faces)
      for (const int t : triangles_[f])
        if (const auto height = height_in(t, part_.faces[f].surface.kind, hole))
          closed[*height > length / 2 ? 1 : 0] = true;
    return closed;
  }

  // Where a triangle crosses the axis of a hole, extended beyond its ends by what a round bottom needs. The opposite
  // side of a bore into which the hole leads is no bottom.
  [[nodiscard]] std::optional<double> height_in(int triangle, SurfaceKind kind, const Hole& hole) const {
    const double length = glm::distance(hole.from, hole.to);
    if (!(length > 0)) return std::nullopt;
    const Vec3 axis = (hole.to - hole.from) / length;
    const double slack = std::max(1e-6 * length, 32 * part_.tolerance);
    const double beyond = (kind == SurfaceKind::cylinder ? 0 : hole.diameters.back() / 2) + slack;
    const std::array<int, 3> corners = mesh_.triangle(triangle);
    std::array<Vec3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = mesh_.point(corners[k]) - hole.from;
    const std::optional<double> height = height_on_axis(p, axis, slack);
    return height && *height >= -beyond && *height <= length + beyond ? height : std::nullopt;
  }

  const mesh::Mesh& mesh_;
  const PartFaces& part_;
  std::vector<std::vector<int>> beside_, triangles_;
  std::vector<char> used_;
};

Vec3 seen_along(const Vec3& point, const Vec3& axis) { return point - glm::dot(point, axis) * axis; }

}  // namespace

std::optional<double> height_on_axis(const std::array<Vec3, 3>& corners, const Vec3& axis, double slack) {
  std::array<double, 3> area;  // opposite to each corner, seen along the axis; twice
  for (int k = 0; k < 3; ++k) area[k] = glm::dot(axis, glm::cross(corners[(k + 1) % 3], corners[(k + 2) % 3]));
  const double sum = area[0] + area[1] + area[2], way = sum < 0 ? -1 : 1;
  double longest = 0, aside = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const Vec3 from = seen_along(corners[(k + 1) % 3], axis), to = seen_along(corners[(k + 2) % 3], axis);
    longest = std::max(longest, glm::distance(from, to));
    aside = std::min(aside, distance_to_segment(Vec3(0), from, to));
  }
  const bool is_inside = std::all_of(area.begin(), area.end(), [way](double one) { return way * one >= 0; });
  if (!is_inside && aside > slack) return std::nullopt;
  if (std::abs(sum) <= slack * longest) return std::nullopt;  // along the axis
  return glm::dot(axis, area[0] * corners[0] + area[1] * corners[1] + area[2] * corners[2]) / sum;
}

std::vector<Hole> find_holes(const mesh::Mesh& mesh, const PartFaces& part) { return HoleFinder(mesh, part).find(); }

}  // namespace epura::surfaces
