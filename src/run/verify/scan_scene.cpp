// SPDX-License-Identifier: Apache-2.0
#include "verify/scan_scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "edges/thread_lines.hpp"

namespace epura::verify {

namespace {

constexpr std::size_t edges_at_once = 4096;
// An edge that leads behind the viewer ends at this fraction of the way to the viewer's plane.
constexpr double nearly_there = 1 - 0x1p-20;

Sight<Bounded> sight_of(const VerifyInput& input, const Vec3& reference) {
  return sight_from(viewing_of(input), triple<Bounded>(reference));
}

// The vertex nearest to the middle of the world, of those in front of the viewer.
Vec3 reference_of(const VerifyInput& input) {
  const world::World& world = input.world;
  const projection::Projection& p = input.projection;
  const Vec3 middle = world.box.centre();
  const auto is_seen = [&](const Vec3& x) { return !p.central || glm::dot(p.n, p.projector - x) > 0; };
  Vec3 best = middle;
  double min = HUGE_VAL;
  const auto try_all = [&](const auto& vertices) {
    for (const int v : vertices) {
      const double distance = glm::length(world.points[v] - middle);
      if (!(distance < min) || !is_seen(world.points[v])) continue;
      min = distance;
      best = world.points[v];
    }
  };
  for (const auto& triangle : world.triangles) try_all(triangle);
  for (const auto& wire : world.wires) try_all(wire);
  return best;
}

// Edges of which facets alone hide a part.
std::vector<std::array<int, 2>> hidden_by_facets(const VerifyInput& input) {
  std::vector<std::array<int, 2>> edges;
  for (const visibility::FacetsSpan& span : input.hidden.by_facets) {
    const edges::FeatureEdge& edge = input.drawn.edges[span.edge];
    edges.push_back(input.vertices_of(edge.model, edge.mesh_edge));
  }
  std::ranges::sort(edges);
  return edges;
}

std::vector<std::array<int, 2>> left_out_of(const VerifyInput& input, double thread_depth) {
  std::vector<std::array<int, 2>> edges;
  const auto add = [&](int model, int mesh_edge) { edges.push_back(input.vertices_of(model, mesh_edge)); };
  for (const edges::MeshEdgeOfModel& edge : edges::chamfer_circles(input.world, input.projection, thread_depth))
    add(edge.model, edge.mesh_edge);
  // Where facets would turn over or fold back, the slices tell (LineMarks); not where a surface hides what is drawn.
  for (const int e : input.hidden.by_surface) {
    const edges::FeatureEdge& edge = input.drawn.edges[e];
    if (!edge.by_chance && edge.hollow == 0) add(edge.model, edge.mesh_edge);
  }
  std::ranges::sort(edges);
  return edges;
}

}  // namespace

ScanScene::ScanScene(const VerifyInput& input, double precision, double thread_depth)
    : world(input.world),
      local(input.world.points.size()),
      vague_(input.world.points.size()),
      left_out_(left_out_of(input, thread_depth)),
      hidden_by_facets_(hidden_by_facets(input)) {
  const Vec3 reference = reference_of(input);
  const Sight<Bounded> sight = sight_of(input, reference);
  const Vec4 base = input.drawing.world_to_page * Vec4(reference, 1);
  origin = Vec2(base) / base.w;
  page = sight.page;
  depth = sight.depth;
  k = sight.inverse_distance.value;
  eye_ = sight.eye ? sight.eye->value : HUGE_VAL;
  max = std::min(eye_, sight.nearest ? sight.nearest->value : HUGE_VAL);
  min = sight.farthest ? sight.farthest->value : -HUGE_VAL;
  parallel_for(local.size(), edges_at_once, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const Triple<Bounded> p = sight.local(world.points[v]);
      local[v] = {p.x.value, p.y.value, p.z.value};
      const double error = p.x.error + p.y.error + sight.inverse_distance.error * p.z.value * p.z.value;
      vague_[v] = local[v].z < eye_ && !(page * error <= precision * (1 - k * local[v].z)) ? 1 : 0;
    }
  });
}

bool ScanScene::is_vague(int triangle) const {
  return std::ranges::any_of(world.triangles[triangle], [&](int v) { return vague_[v] != 0; });
}

bool ScanScene::is_vague(const std::array<int, 2>& edge) const {
  return std::ranges::any_of(edge, [&](int v) { return vague_[v] != 0; });
}

bool ScanScene::is_left_out(const std::array<int, 2>& edge) const {
  return std::ranges::binary_search(left_out_, edge);
}

bool ScanScene::is_hidden_by_facets(const std::array<int, 2>& edge) const {
  return std::ranges::binary_search(hidden_by_facets_, edge);
}

bool ScanScene::is_at_limit(const std::array<int, 2>& edge) const {
  const double slack = 1e-9 * glm::length(world.box.size());
  return std::ranges::any_of(std::array{min, max}, [&](double limit) {
    return std::ranges::all_of(edge, [&](int v) { return std::abs(local[v].z - limit) <= slack; });
  });
}

std::optional<std::array<Vec2, 2>> ScanScene::line_of(const std::array<int, 2>& edge) const {
  std::array<Vec3, 2> ends{local[edge[0]], local[edge[1]]};
  const std::array<bool, 2> seen{is_before_viewer(edge[0]), is_before_viewer(edge[1])};
  if (!seen[0] && !seen[1]) return std::nullopt;
  if (seen[0] != seen[1]) {
    const Vec3 from = ends[seen[0] ? 0 : 1], to = ends[seen[0] ? 1 : 0];
    ends[seen[0] ? 1 : 0] = from + nearly_there * (eye_ - from.z) / (to.z - from.z) * (to - from);
  }
  return std::array{to_page(ends[0]), to_page(ends[1])};
}

}  // namespace epura::verify
