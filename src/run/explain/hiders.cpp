// SPDX-License-Identifier: Apache-2.0
#include "explain/hiders.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace epura::explain {

namespace {

// Rounding moves vertices by less than a cell of the page grid.
template <class Vertices>
TriangleBoxes::Box box_of(const view::ProjectedScene& view, const Vertices& vertices) {
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  for (const int v : vertices) {
    const Vec2 place(view.vertices[v].x, view.vertices[v].y);
    min = glm::min(min, place - view.cell);
    max = glm::max(max, place + view.cell);
  }
  return {{{min.x, max.x}, {min.y, max.y}}};
}

// Returns the distance of a triangle in front of a point, along the line of sight through it; 0 if that lies in its
// plane.
double ahead_of(const ExplainInput& drawn_view, int triangle, const Vec3& point) {
  const projection::Projection& projection = drawn_view.view.projection;
  const Vec3 sight = glm::normalize(projection.central ? projection.projector - point : projection.projector);
  const auto& corners = drawn_view.world.triangles[triangle];
  const Vec3 a = drawn_view.world.points[corners[0]];
  const Vec3 normal = glm::cross(drawn_view.world.points[corners[1]] - a, drawn_view.world.points[corners[2]] - a);
  const double across = glm::dot(normal, sight);
  return across == 0 ? 0 : glm::dot(normal, a - point) / across;
}

}  // namespace

TriangleBoxes::TriangleBoxes(const view::ProjectedScene& view) : boxes_(view.triangles.size()) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i] = box_of(view, view.triangles[i].vertex);
  tree_ = search::BoundsTree<2>(boxes_.size(), [&](std::size_t i) { return boxes_[i]; });
}

std::vector<Occlusion> find_hiders(const ExplainInput& drawn_view, const TriangleBoxes& boxes, std::size_t e) {
  const view::ProjectedScene& view = drawn_view.view;
  const edges::FeatureEdge& edge = drawn_view.drawn.edges[e];
  const visibility::PageEdge line{edge.vertex[0], edge.vertex[1]};
  const auto ends = ends_of(drawn_view, drawn_subject(drawn_view, e));

  const visibility::OwnTriangles own(drawn_view.world, drawn_view.drawn, edge);
  std::map<FaceName, Occlusion> found;
  boxes.meeting(box_of(view, edge.vertex), [&](int number) {
    const view::ViewTriangle& triangle = view.triangles[number];
    const auto& [i, j, k] = triangle.vertex;
    // A triangle seen edge-on hides nothing.
    if (view::cross(view.grid[i], view.grid[j], view.grid[k]) == 0) return;
    if (own.contain(triangle.source)) return;
    const auto part = visibility::hidden_part(view, line, triangle);
    if (!part) return;
    const double t = drawing::parameter_in_space(view, edge, ((*part)[0] + (*part)[1]) / 2);
    const double ahead = ahead_of(drawn_view, triangle.source, ends[0] + t * (ends[1] - ends[0]));
    const FaceName face = face_of(drawn_view.world, triangle.source);
    Occlusion& hider = found.try_emplace(face, Occlusion{face, {}, ahead}).first->second;
    visibility::add_span(hider.parts, *part);
    hider.ahead = std::min(hider.ahead, ahead);
  });

  std::vector<Occlusion> hiders;
  for (auto& [face, hider] : found) hiders.push_back(std::move(hider));
  std::stable_sort(hiders.begin(), hiders.end(),
                   [](const Occlusion& a, const Occlusion& b) { return a.ahead < b.ahead; });
  return hiders;
}

}  // namespace epura::explain
