// SPDX-License-Identifier: Apache-2.0
#include "drawing/known_circles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <span>

#include "base/error.hpp"
#include "base/range.hpp"
#include "construction/figure.hpp"
#include "drawing/limits.hpp"
#include "drawing/places.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::drawing {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

struct Circle {
  Vec3 centre, axis;
  double radius;
};

struct Axis {
  Vec3 origin, direction;
};

// A ball is round about any axis: about the normal of a plane that cuts it, too.
std::optional<Axis> axis_of(const PartSurface& surface, const PartSurface& other) {
  if (surface.kind == SurfaceKind::sphere && other.kind == SurfaceKind::plane) return Axis{surface.origin, other.axis};
  if (!world::is_round(surface.kind) || surface.kind == SurfaceKind::sphere) return std::nullopt;
  return Axis{surface.origin, surface.axis};
}

std::optional<Circle> circle_about(const Axis& axis, std::span<const Vec3> points, double tolerance) {
  Range height, radius;
  for (const Vec3& p : points) {
    const double along = glm::dot(p - axis.origin, axis.direction);
    height.add(along);
    radius.add(glm::distance(p, axis.origin + along * axis.direction));
  }
  if (!(std::max(height.size(), radius.size()) <= 2 * tolerance)) return std::nullopt;
  return Circle{axis.origin + height.middle() * axis.direction, axis.direction, radius.middle()};
}

// The circle on which a border of a model lies.
std::optional<Circle> circle_of_border(const PartEdges& edges, int model, int number) {
  const world::Placed& placed = edges.placed(model);
  const world::PlacedPart& part = *edges.part(model);
  const surfaces::PartBorder& border = placed.part->borders[static_cast<std::size_t>(number)];
  if (border.faces[0] < 0 || border.faces[0] == border.faces[1] || border.edges.size() < min_edges_of_rim)
    return std::nullopt;
  const mesh::Mesh& mesh = placed.mesh->whole();
  std::vector<Vec3> points;
  for (const int edge : border.edges)
    for (const int vertex : mesh.edges[static_cast<std::size_t>(edge)].vertex)
      points.emplace_back(placed.to_world * Vec4(mesh.point(vertex), 1));
  const auto surface_of = [&](std::size_t side) -> const PartSurface& {
    return part.faces[static_cast<std::size_t>(border.faces[side])].surface;
  };
  for (const std::size_t side : {0, 1}) {
    const PartSurface& surface = surface_of(side);
    const auto axis = axis_of(surface, surface_of(1 - side));
    std::optional<Circle> circle = axis ? circle_about(*axis, points, part.tolerance) : std::nullopt;
    if (!circle) continue;
    if (surface.kind == SurfaceKind::cylinder) circle->radius = surface.radius;
    check(circle->radius >= 0, "a circle has a radius");
    return circle;
  }
  return std::nullopt;
}

// Nothing for circles seen edge-on.
std::optional<Ellipse> image_of(const Circle& circle, const Mat4& map) {
  const auto [p, q] = surfaces::square_to(circle.axis);
  const auto radius = [&](const Vec3& direction) { return Vec2(map * Vec4(circle.radius * direction, 0)); };
  const Vec2 centre(map * Vec4(circle.centre, 1));
  const construction::Curve image = construction::ellipse_of(centre, radius(p), radius(q));
  Ellipse ellipse{centre, image.u, image.v};
  const double longer = glm::length(ellipse.u), shorter = glm::length(ellipse.v);
  if (!(shorter > rounding_part * longer)) return std::nullopt;
  if (longer - shorter < rounding_part * longer) ellipse = {centre, {longer, 0}, {0, longer}};
  if (ellipse.u.x * ellipse.v.y < ellipse.u.y * ellipse.v.x) ellipse.v = -ellipse.v;
  return ellipse;
}

/// Finds each circle once.
class Finder {
 public:
  Finder(const PartEdges& edges, const ViewDrawing& drawing) : edges_(edges), drawing_(drawing) {}

  KnownCircles find() {
    for (const Chain& chain : drawing_.chains) found_.of_chain.push_back(circles_of(chain));
    return std::move(found_);
  }

 private:
  std::vector<int> circles_of(const Chain& chain) {
    Places<int> circles_of_middles(drawing_.distances.coincident);
    for (const int number : chain.segments) {
      const Segment& segment = drawing_.segments[static_cast<std::size_t>(number)];
      if (is_link(segment)) continue;
      if (const int circle = circle_of(segment); circle >= 0)
        circles_of_middles.add((segment.from + segment.to) / 2.0, circle);
    }
    if (circles_of_middles.empty()) return {};
    std::vector<int> circles;
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
      const Vec2 &a = chain.points[i], &b = chain.points[(i + 1) % chain.points.size()];
      const int* circle = circles_of_middles.find((a + b) / 2.0);
      circles.push_back(circle == nullptr ? -1 : *circle);
    }
    return circles;
  }

  int circle_of(const Segment& segment) {
    const int border = edges_.border_of(segment);
    if (border < 0) return -1;
    const auto [known, is_new] = numbers_.try_emplace({segment.model, border}, -1);
    if (!is_new) return known->second;
    const auto circle = circle_of_border(edges_, segment.model, border);
    const auto image = circle ? image_of(*circle, drawing_.world_to_page) : std::nullopt;
    if (!image) return -1;
    known->second = static_cast<int>(found_.ellipses.size());
    found_.ellipses.push_back(*image);
    return known->second;
  }

  const PartEdges& edges_;
  const ViewDrawing& drawing_;
  std::map<std::array<int, 2>, int> numbers_{};  // by model and border
  KnownCircles found_{};
};

}  // namespace

KnownCircles known_circles(const PartEdges& edges, const ViewDrawing& drawing) {
  if (drawing.projection.central) return {};
  return Finder(edges, drawing).find();
}

}  // namespace epura::drawing
