// SPDX-License-Identifier: Apache-2.0
#include "composition/line_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "drawing/drawing.hpp"

namespace epura::pipeline {

namespace {

constexpr std::size_t max_faces = 4;
// A list of depths must not be much longer than the line itself.
constexpr std::size_t max_depths = 16;
// mm on paper; lines are merged and moved by less.
constexpr double on_edge = 0.2;
constexpr double same_depth = 1e-4;

/// A position on the page and its depth.
struct DeepPoint {
  Vec2 at;
  double depth;
};

/// Finds edges of the models of a view.
class EdgeFinder {
 public:
  EdgeFinder(const drawing::ViewDrawing& drawing, const world::World& world)
      : drawing_(drawing), world_(world), shown_(world.models.size()) {
    for (int model = 0; model < static_cast<int>(world.models.size()); ++model)
      shown_[static_cast<std::size_t>(world.number_in_scene(model))].push_back(model);
  }

  // In the world, also if a cut has left the vertex out.
  [[nodiscard]] Vec3 point(int model, int vertex) const {
    const world::Placed& placed = world_.models[static_cast<std::size_t>(model)];
    if (placed.mesh->uncut != nullptr) return Vec3(placed.to_world * Vec4(placed.mesh->whole().point(vertex), 1));
    return world_.points[static_cast<std::size_t>(world_.first_vertex[static_cast<std::size_t>(model)] + vertex)];
  }

  [[nodiscard]] DeepPoint on_page(const Vec3& p) const {
    const Vec4 mapped = drawing_.world_to_page * Vec4(p, 1);
    return {Vec2(mapped) / mapped.w, mapped.z / mapped.w};
  }

  [[nodiscard]] std::array<Vec3, 2> ends(const sheet::ModelEdge& edge) const {
    return {point(edge.model, edge.vertex[0]), point(edge.model, edge.vertex[1])};
  }

  void add_faces(const sheet::ModelEdge& edge, std::vector<int>& faces, int& body) const {
    const mesh::Mesh& mesh = world_.models[static_cast<std::size_t>(edge.model)].mesh->whole();
    const mesh::MeshEdge* found = mesh.edge_between(edge.vertex);
    if (found == nullptr) return;
    for (const int triangle : mesh.triangles_of(*found)) {
      faces.push_back(mesh.polygon[static_cast<std::size_t>(triangle)]);
      if (body < 0) body = mesh.body[static_cast<std::size_t>(triangle)];
    }
  }

  // The depth of a point of a line that draws `edges`: that of the nearest of them. On the page, depth is linear along
  // a line, in perspectives, too.
  [[nodiscard]] std::optional<double> depth(const Vec2& drawn, std::span<const sheet::ModelEdge> edges) const;

 private:
  const drawing::ViewDrawing& drawing_;
  const world::World& world_;
  std::vector<std::vector<int>> shown_;  ///< models of the world, by number in the scene
};

std::optional<double> EdgeFinder::depth(const Vec2& drawn, std::span<const sheet::ModelEdge> edges) const {
  const Vec2 p = drawing_.shown.breaks.restored(drawn);
  std::optional<double> found;
  double least = on_edge + drawing_.distances.contours_moved;
  for (const sheet::ModelEdge& edge : edges)
    for (const int model : shown_[static_cast<std::size_t>(edge.model)]) {
      const DeepPoint a = on_page(point(model, edge.vertex[0])), b = on_page(point(model, edge.vertex[1]));
      const double t = nearest_parameter(p, a.at, b.at), distance = glm::distance(p, a.at + t * (b.at - a.at));
      if (!(distance < least)) continue;
      least = distance;
      found = a.depth + t * (b.depth - a.depth);
    }
  return found;
}

// The plane a x + b y + c of depths; nothing if they are not in one, or in one that is seen edge-on.
std::optional<std::vector<double>> plane_of(const std::vector<DeepPoint>& points) {
  const DeepPoint &first = points.front(), &second = points[points.size() / 3], &third = points[points.size() * 2 / 3];
  const Vec2 u = second.at - first.at, v = third.at - first.at;
  const double area = cross(u, v);
  if (std::abs(area) < 1e-2 * glm::length(u) * glm::length(v) || area == 0) return std::nullopt;
  const double du = second.depth - first.depth, dv = third.depth - first.depth;
  const Vec2 slope((du * v.y - dv * u.y) / area, (dv * u.x - du * v.x) / area);
  const double at_origin = first.depth - glm::dot(slope, first.at);
  const auto is_off = [&](const DeepPoint& point) {
    return std::abs(glm::dot(slope, point.at) + at_origin - point.depth) > 10 * same_depth;
  };
  if (std::any_of(points.begin(), points.end(), is_off)) return std::nullopt;
  return std::vector{slope.x, slope.y, at_origin};
}

std::vector<double> depths_of(const sheet::Stroke& stroke, const EdgeFinder& finder) {
  // A line of more edges than points has been simplified; long ones are curves, of which a few points tell the plane.
  std::vector<DeepPoint> points;
  const std::size_t step = std::max<std::size_t>(1, stroke.points.size() / max_depths);
  for (std::size_t i = 0; i < stroke.points.size(); i += step) {
    const std::optional<double> depth = finder.depth(stroke.points[i], stroke.edges);
    if (!depth) return {};
    points.push_back({stroke.points[i], *depth});
  }
  if (points.empty()) return {};
  const auto is_same = [&](const DeepPoint& point) {
    return std::abs(point.depth - points.front().depth) <= same_depth;
  };
  if (std::all_of(points.begin(), points.end(), is_same)) return {points.front().depth};
  const bool is_list = step == 1 && stroke.curves.empty() && points.size() != 3;
  if (points.size() >= 3 && !is_list)
    if (const auto plane = plane_of(points)) return *plane;
  if (!is_list) return {};
  std::vector<double> depths;
  for (const DeepPoint& point : points) depths.push_back(point.depth);
  return depths;
}

sheet::LineFacts facts_of(const sheet::Stroke& stroke, const EdgeFinder& finder) {
  sheet::LineFacts facts;
  // A closed line may begin inside an edge and end there, too.
  const std::span<const sheet::ModelEdge> edges(stroke.edges);
  const bool repeats_first = edges.size() > 1 && edges.front() == edges.back();
  for (const sheet::ModelEdge& edge : repeats_first ? edges.first(edges.size() - 1) : edges) {
    const auto [from, to] = finder.ends(edge);
    facts.length += glm::distance(from, to);
    finder.add_faces(edge, facts.faces, facts.body);
  }
  std::sort(facts.faces.begin(), facts.faces.end());
  facts.faces.erase(std::unique(facts.faces.begin(), facts.faces.end()), facts.faces.end());
  if (facts.faces.size() > max_faces) {
    facts.more_faces = static_cast<int>(facts.faces.size() - max_faces);
    facts.faces.resize(max_faces);
  }
  facts.depth = depths_of(stroke, finder);
  return facts;
}

}  // namespace

void add_line_facts(sheet::Sheet& sheet, const drawing::ViewDrawing& drawing, const world::World& world) {
  const EdgeFinder finder(drawing, world);
  std::vector<sheet::Stroke*> strokes;
  for (sheet::Layer& layer : sheet.layers) {
    if (layer.name.substr(0, layer.name.rfind('/')) != drawing.name) continue;
    for (sheet::Stroke& stroke : layer.strokes)
      if (!stroke.edges.empty()) strokes.push_back(&stroke);
  }
  const std::size_t first = sheet.line_facts.size();
  sheet.line_facts.resize(first + strokes.size());
  constexpr std::size_t at_once = 256;
  parallel_for(strokes.size(), at_once, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      strokes[i]->facts = static_cast<int>(first + i);
      sheet.line_facts[first + i] = facts_of(*strokes[i], finder);
    }
  });
}

}  // namespace epura::pipeline
