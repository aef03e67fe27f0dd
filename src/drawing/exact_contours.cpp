// SPDX-License-Identifier: Apache-2.0
#include "drawing/exact_contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "drawing/conic_fit.hpp"
#include "drawing/places.hpp"
#include "search/line_cells.hpp"
#include "world/placed_part.hpp"

namespace epura::drawing {

namespace {

using features::PartSurface;
using features::SurfaceKind;

// Millimetres between a line and the edge of the mesh that it shows; others are on the surface already.
constexpr double same_place = 1e-6;
// Lines at smaller angles do not cross.
constexpr double least_sine = 1e-6;
// Radians about the axis between the ends of a generator, which files round.
constexpr double most_turn = 1e-3;

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

// Whether an edge runs along a generator rather than across facets.
bool is_along_generator(const PartSurface& surface, const Vec3& from, const Vec3& to) {
  const auto away = [&](const Vec3& point) {
    const Vec3 out = point - surface.origin;
    return glm::normalize(out - glm::dot(out, surface.axis) * surface.axis);
  };
  return glm::length(glm::cross(away(from), away(to))) < most_turn;
}

// The point of a surface at the height of another point, in a direction away from the axis.
Vec3 on_surface(const PartSurface& surface, const Vec3& point, const Vec3& away) {
  const double height = glm::dot(point - surface.origin, surface.axis);
  return surface.origin + height * surface.axis + (surface.radius + surface.slope * height) * away;
}

/// The cylinders and cones of a model.
class Model {
 public:
  explicit Model(const world::Placed& placed) : placed_(&placed), part_(world::place_part(placed)) {}

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
  const world::Placed* placed_;
  std::optional<world::PlacedPart> part_;
};

struct Line {
  Vec2 from, to;
};

/// A contour of facets, and where it is on the surface.
struct Moved {
  Line facets, surface;
  std::array<bool, 2> ends_in_edge;  ///< something hides the rest of the edge
};

/// Part of a line of the drawing that may hide others, as facets have it and as it is drawn.
struct Occluder {
  Line facets;
  std::optional<Ellipse> arc{};
  std::optional<Line> contour{};  ///< moved
  bool crosses_faces = false;     ///< where two faces meet, which is as inaccurate as facets are
  bool visible = true;

  [[nodiscard]] bool is_moved() const { return arc || contour; }
};

// Where a line crosses what is drawn of an occluder, nearest to its beginning.
std::optional<Vec2> crossing(const Line& line, const Occluder& occluder) {
  const Vec2 along = glm::normalize(line.to - line.from);
  double at = HUGE_VAL;
  if (occluder.arc) {
    const Ellipse& e = *occluder.arc;
    const auto local = [&](const Vec2& p) {
      return Vec2(glm::dot(p, e.u) / glm::dot(e.u, e.u), glm::dot(p, e.v) / glm::dot(e.v, e.v));
    };
    const Vec2 p = local(line.from - e.centre), d = local(along);
    const double a = glm::dot(d, d), b = glm::dot(p, d), root = b * b - a * (glm::dot(p, p) - 1);
    if (!(root >= 0)) return std::nullopt;
    const double one = (-b - std::sqrt(root)) / a, other = (-b + std::sqrt(root)) / a;
    at = std::abs(one) < std::abs(other) ? one : other;
  } else {
    const Line& other = occluder.contour ? *occluder.contour : occluder.facets;
    const Vec2 direction = glm::normalize(other.to - other.from);
    const double sine = cross(along, direction);
    if (!(std::abs(sine) > least_sine)) return std::nullopt;
    at = cross(other.from - line.from, direction) / sine;
  }
  return std::abs(at) <= glm::distance(occluder.facets.from, occluder.facets.to) ? std::optional(line.from + at * along)
                                                                                 : std::nullopt;
}

/// The occluders at a place.
class Occluders {
 public:
  explicit Occluders(std::vector<Occluder> all) : all_(std::move(all)) {
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (const Occluder& one : all_) {
      min = glm::min(min, glm::min(one.facets.from, one.facets.to));
      max = glm::max(max, glm::max(one.facets.from, one.facets.to));
    }
    const int side = std::clamp(static_cast<int>(std::sqrt(all_.size())), 1, 512);
    grid_ = {min, glm::max(max - min, Vec2(1)) / static_cast<double>(side), side, side};
    in_cell_.resize(static_cast<std::size_t>(grid_.count()));
    for (std::size_t i = 0; i < all_.size(); ++i)
      search::visit_cells(grid_, all_[i].facets.from, all_[i].facets.to, 0,
                          [&](int cell, double, double) { in_cell_[static_cast<std::size_t>(cell)].push_back(i); });
  }

  template <class Is>
  [[nodiscard]] bool any_at(const Vec2& place, double distance, const Is& is) const {
    const auto& here = at(place);
    return std::any_of(here.begin(), here.end(), [&](std::size_t i) {
      return is(all_[i]) && distance_to_segment(place, all_[i].facets.from, all_[i].facets.to) <= distance;
    });
  }

  // Where a moved line ends that ended within `distance` of an occluder; what has moved hides before what has not.
  [[nodiscard]] std::optional<Vec2> end_of(const Line& line, const Vec2& end, double distance) const {
    std::optional<Vec2> nearest;
    for (const bool moved : {true, false}) {
      for (const std::size_t i : at(end)) {
        const Occluder& one = all_[i];
        if (!one.visible || one.is_moved() != moved ||
            distance_to_segment(end, one.facets.from, one.facets.to) > distance)
          continue;
        const auto place = crossing(line, one);
        if (place && (!nearest || glm::distance(*place, line.from) < glm::distance(*nearest, line.from)))
          nearest = place;
      }
      if (nearest) return nearest;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] const std::vector<std::size_t>& at(const Vec2& place) const {
    return in_cell_[static_cast<std::size_t>(grid_.cell(grid_.column(place.x), grid_.row(place.y)))];
  }

  std::vector<Occluder> all_;
  search::CellGrid grid_{};
  std::vector<std::vector<std::size_t>> in_cell_;
};

class Mover {
 public:
  Mover(const world::World& world, ViewDrawing& drawing)
      : drawing_(drawing), towards_viewer_(glm::normalize(drawing.projection.projector)), moved_(drawing.coincident) {
    for (const world::Placed& placed : world.models) models_.emplace_back(placed);
  }

  double move() {
    std::vector<Moved> contours;
    for (const Segment& segment : drawing_.segments)
      if (segment.kind == EdgeKind::contour && !is_link(segment))
        if (const auto moved = moved_contour(segment)) contours.push_back(*moved);
    if (contours.empty()) return 0;
    const Occluders occluders(all_occluders(contours));
    for (const Moved& contour : contours) {
      if (!can_move(occluders, contour.facets.from, contour.ends_in_edge[0])) continue;
      if (!can_move(occluders, contour.facets.to, contour.ends_in_edge[1])) continue;
      add_end(occluders, contour.facets.from, contour.surface, contour.ends_in_edge[0]);
      add_end(occluders, contour.facets.to, {contour.surface.to, contour.surface.from}, contour.ends_in_edge[1]);
    }
    for (Chain& chain : drawing_.chains) move(chain);
    return farthest_;
  }

 private:
  [[nodiscard]] Vec2 on_page(const Vec3& point) const { return Vec2(drawing_.world_to_page * Vec4(point, 1)); }

  [[nodiscard]] std::optional<Moved> moved_contour(const Segment& segment) const {
    const auto edge = models_[static_cast<std::size_t>(segment.model)].inside(segment);
    if (!edge || !is_along_generator(*edge->surface, edge->ends[0], edge->ends[1])) return std::nullopt;
    const auto generators = generators_of(*edge->surface, towards_viewer_);
    if (!generators) return std::nullopt;
    const auto at = [&](double t) { return edge->ends[0] + t * (edge->ends[1] - edge->ends[0]); };
    const Vec3 out = at(0.5) - edge->surface->origin;
    const bool first = glm::dot(out, (*generators)[0]) > glm::dot(out, (*generators)[1]);
    const Vec3& away = (*generators)[first ? 0 : 1];
    const Vec3 from = at(segment.t[0]), to = at(segment.t[1]);
    if (!(glm::distance(on_page(from), segment.from) <= same_place)) return std::nullopt;
    if (!(glm::distance(on_page(to), segment.to) <= same_place)) return std::nullopt;
    const auto moved = [&](const Vec3& point) { return on_page(on_surface(*edge->surface, point, away)); };
    const auto is_inside = [](double t) { return t != 0 && t != 1; };
    return Moved{
        {segment.from, segment.to}, {moved(from), moved(to)}, {is_inside(segment.t[0]), is_inside(segment.t[1])}};
  }

  // Lines as they are before any of them moves.
  [[nodiscard]] std::vector<Occluder> all_occluders(const std::vector<Moved>& contours) const {
    std::vector<Occluder> all;
    for (const Moved& contour : contours) all.push_back({contour.facets, {}, contour.surface});
    for (const Chain& chain : drawing_.chains) {
      const std::size_t count = chain.points.size();
      for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i)
        all.push_back({{chain.points[i], chain.points[(i + 1) % count]},
                       {},
                       {},
                       chain.kind == EdgeKind::intersection,
                       chain.visible});
      for (const CurvePart& curve : chain.curves) {
        check(curve.first >= 0 && curve.last - curve.first <= static_cast<int>(count), "an arc is a part of its line");
        for (int i = curve.first; i < curve.last; ++i)
          all[all.size() - count + (chain.closed ? 0 : 1) + static_cast<std::size_t>(i) % count].arc =
              Ellipse{curve.centre, curve.u, curve.v};
      }
    }
    return all;
  }

  // Whether a contour still meets what it ends at: the arc of a rim, or what hides the rest of it.
  [[nodiscard]] bool can_move(const Occluders& occluders, const Vec2& end, bool ends_in_edge) const {
    if (!ends_in_edge)
      return occluders.any_at(end, drawing_.coincident, [](const Occluder& one) { return one.arc.has_value(); });
    return !occluders.any_at(end, drawing_.coincident, [](const Occluder& one) { return one.crosses_faces; });
  }

  // `surface` begins at the end that moves.
  void add_end(const Occluders& occluders, const Vec2& end, const Line& surface, bool ends_in_edge) {
    Vec2 place = surface.from;
    if (ends_in_edge) place = occluders.end_of(surface, end, drawing_.coincident).value_or(place);
    moved_.add(end, place);
    farthest_ = std::max(farthest_, glm::distance(end, place));
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

double move_contours(const world::World& world, ViewDrawing& drawing) {
  return drawing.projection.central ? 0 : Mover(world, drawing).move();
}

}  // namespace epura::drawing
