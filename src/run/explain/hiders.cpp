// SPDX-License-Identifier: Apache-2.0
#include "explain/hiders.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/parallel.hpp"

namespace epura::explain {

namespace {

constexpr std::size_t grain = 4096;

// Rounding moves vertices by less than a cell of the page grid.
template <class Vertices>
projection::Window box_of(const view::ProjectedScene& view, const Vertices& vertices) {
  projection::Window box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const int v : vertices) {
    const Vec2 place(view.vertices[v].x, view.vertices[v].y);
    box.min = glm::min(box.min, place - view.cell);
    box.max = glm::max(box.max, place + view.cell);
  }
  return box;
}

template <class Make>
std::vector<projection::Window> boxes(std::size_t count, Make make) {
  std::vector<projection::Window> made(count);
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) made[i] = make(i);
  });
  return made;
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

TriangleBoxes::TriangleBoxes(const view::ProjectedScene& view) {
  levels_.push_back(
      boxes(view.triangles.size(), [&](std::size_t i) { return box_of(view, view.triangles[i].vertex); }));
  while (levels_.back().size() > run) {
    const std::vector<projection::Window>& below = levels_.back();
    levels_.push_back(boxes((below.size() + run - 1) / run, [&](std::size_t i) {
      projection::Window box = below[i * run];
      for (std::size_t j = i * run; j < std::min((i + 1) * run, below.size()); ++j) {
        box.min = glm::min(box.min, below[j].min);
        box.max = glm::max(box.max, below[j].max);
      }
      return box;
    }));
  }
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
