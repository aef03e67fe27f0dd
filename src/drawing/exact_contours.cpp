// SPDX-License-Identifier: Apache-2.0
#include "drawing/exact_contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>

#include "drawing/conic_fit.hpp"
#include "drawing/places.hpp"
#include "scene/placed_part.hpp"

namespace epura::drawing {

namespace {

using features::PartSurface;
using features::SurfaceKind;

// Millimetres between a line and the edge of the mesh that it shows; others are on the surface already.
constexpr double same_place = 1e-6;

/// The generators of a cylinder or cone at which it turns away from the viewer: directions away from its axis.
std::optional<std::array<Vec3, 2>> generators_of(const PartSurface& surface, const Vec3& towards_viewer) {
  const double along = glm::dot(surface.axis, towards_viewer);
  const Vec3 across = towards_viewer - along * surface.axis;
  const double length = glm::length(across);
  // A normal is u - slope * axis, for the unit vector u away from the axis.
  const double cosine = surface.slope * along / length;
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  const Vec3 u = across / length, v = glm::cross(surface.axis, u);
  const double sine = std::sqrt(1 - cosine * cosine);
  return std::array{cosine * u + sine * v, cosine * u - sine * v};
}

// The point of a surface at the height of another point, in a direction away from the axis.
Vec3 on_surface(const PartSurface& surface, const Vec3& point, const Vec3& away) {
  const double height = glm::dot(point - surface.origin, surface.axis);
  return surface.origin + height * surface.axis + (surface.radius + surface.slope * height) * away;
}

/// The cylinders and cones of a model.
class Model {
 public:
  explicit Model(const scene::Placed& placed) : placed_(&placed), part_(scene::place_part(placed)) {}

  struct Edge {
    std::array<Vec3, 2> ends;  ///< in the world
    const PartSurface* surface;
  };

  // The edge of the file that a segment shows, if it lies inside a cylinder or cone.
  [[nodiscard]] std::optional<Edge> inside(const Segment& segment) const {
    if (!part_ || segment.edge[0] < 0) return std::nullopt;
    const mesh::Mesh& mesh = placed_->mesh->whole();
    const mesh::MeshEdge* edge =
        mesh.edge_between({std::min(segment.edge[0], segment.edge[1]), std::max(segment.edge[0], segment.edge[1])});
    if (edge == nullptr) return std::nullopt;
    const std::span<const int> beside = mesh.triangles_of(*edge);
    const auto face = [&](std::size_t i) {
      return placed_->part->face_of_triangle[static_cast<std::size_t>(beside[i])];
    };
    if (beside.size() != 2 || face(0) < 0 || face(0) != face(1)) return std::nullopt;
    const PartSurface& surface = part_->faces[static_cast<std::size_t>(face(0))].surface;
    if (surface.kind != SurfaceKind::cylinder && surface.kind != SurfaceKind::cone) return std::nullopt;
    const auto end = [&](std::size_t i) { return Vec3(placed_->to_world * Vec4(mesh.point(segment.edge[i]), 1)); };
    return Edge{{end(0), end(1)}, &surface};
  }

 private:
  const scene::Placed* placed_;
  std::optional<scene::PlacedPart> part_;
};

// What hides a part of a contour would hide another part of the moved one.
bool is_whole(const Segment& segment) { return std::abs(segment.t[1] - segment.t[0]) == 1; }

class Mover {
 public:
  Mover(const scene::World& world, ViewDrawing& drawing)
      : drawing_(drawing), towards_viewer_(glm::normalize(drawing.projection.projector)), moved_(drawing.coincident) {
    for (const scene::Placed& placed : world.models) models_.emplace_back(placed);
  }

  double move() {
    for (const Segment& segment : drawing_.segments)
      if (segment.kind == EdgeKind::contour && !is_link(segment)) add(segment);
    if (!moved_.empty())
      for (Chain& chain : drawing_.chains) move(chain);
    return farthest_;
  }

 private:
  [[nodiscard]] Vec2 on_page(const Vec3& point) const { return Vec2(drawing_.world_to_page * Vec4(point, 1)); }

  void add(const Segment& segment) {
    const auto edge = models_[static_cast<std::size_t>(segment.model)].inside(segment);
    if (!edge || !is_whole(segment)) return;
    const auto generators = generators_of(*edge->surface, towards_viewer_);
    if (!generators) return;
    const auto at = [&](double t) { return edge->ends[0] + t * (edge->ends[1] - edge->ends[0]); };
    const Vec3 middle = at(0.5), out = middle - edge->surface->origin;
    const Vec3& away =
        glm::dot(out, (*generators)[0]) > glm::dot(out, (*generators)[1]) ? (*generators)[0] : (*generators)[1];
    const std::array<Vec2, 2> ends{segment.from, segment.to};
    std::array<Vec2, 2> moved{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3 point = at(segment.t[i]);
      if (!(glm::distance(on_page(point), ends[i]) <= same_place)) return;
      moved[i] = on_page(on_surface(*edge->surface, point, away));
    }
    for (std::size_t i = 0; i < 2; ++i) {
      moved_.add(ends[i], moved[i]);
      farthest_ = std::max(farthest_, glm::distance(ends[i], moved[i]));
    }
  }

  // Arcs through a place go on as they are; those that end there end where the contour touches them.
  void move(Chain& chain) const {
    const int count = static_cast<int>(chain.points.size());
    for (int i = 0; i < count; ++i) {
      Vec2& point = chain.points[static_cast<std::size_t>(i)];
      const Vec2* moved = moved_.find(point);
      if (moved == nullptr) continue;
      bool inside = false;
      for (const CurvePart& curve : chain.curves)
        inside = inside || (curve.first < i && i < curve.last) || (curve.first < i + count && i + count < curve.last);
      if (inside) continue;
      for (CurvePart& curve : chain.curves) {
        const Ellipse ellipse{curve.centre, curve.u, curve.v};
        const double turn = std::remainder(ellipse.angle_of(*moved) - ellipse.angle_of(point), 2 * std::numbers::pi);
        if (curve.first == i) curve.from += turn;
        if (curve.last == i || curve.last == i + count) curve.to += turn;
      }
      point = *moved;
    }
  }

  ViewDrawing& drawing_;
  Vec3 towards_viewer_;
  std::vector<Model> models_{};
  Places<Vec2> moved_;  ///< by the place of the end of a contour
  double farthest_ = 0;
};

}  // namespace

double move_contours(const scene::World& world, ViewDrawing& drawing) {
  return drawing.projection.central ? 0 : Mover(world, drawing).move();
}

}  // namespace epura::drawing
