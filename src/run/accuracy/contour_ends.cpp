// SPDX-License-Identifier: Apache-2.0
#include "accuracy/contour_ends.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "accuracy/judged_view.hpp"

namespace epura::accuracy {

namespace {

/// Where a surface curves both ways, its contour may end in a cusp, which facets do not have: theirs turns back there,
/// by a side of a facet too early or too late. Of triangles alone, of which no surface is known.
class EndsOfTriangles : JudgedView {
 public:
  using JudgedView::JudgedView;

  [[nodiscard]] double off() const {
    std::vector<Leg> legs = legs_of_saddles();
    if (legs.empty()) return 0;
    const std::vector<char> rims = vertices_of_rims();
    std::erase_if(legs, [&](const Leg& leg) { return rims[static_cast<std::size_t>(leg.from)] != 0; });
    std::stable_sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) { return a.from < b.from; });
    double largest = 0;
    for (std::size_t i = 0; i < legs.size(); ++i)
      for (std::size_t j = i + 1; j < legs.size() && legs[j].from == legs[i].from; ++j) {
        if (!(glm::dot(legs[i].along, legs[j].along) > 0)) continue;
        for (const Leg* leg : {&legs[i], &legs[j]})
          if (leg->is_seen) largest = std::max(largest, leg->off);
      }
    return largest;
  }

 private:
  /// A contour of facets, from one of its ends.
  struct Leg {
    int from;
    Vec2 along;    ///< on paper, mm
    double off;    ///< by which it may end too early or too late, mm
    bool is_seen;  ///< in part
  };

  [[nodiscard]] bool is_seen(std::size_t edge) const {
    bool any = false;
    judged_.hidden.visit_parts(edge, [&](double, double, bool visible) { any = any || visible; });
    return any;
  }

  // A facet that is turned over by chance has no contour of its surface. Whole facets may face the wrong way.
  [[nodiscard]] std::vector<Leg> legs_of_saddles() const {
    std::vector<Leg> legs;
    for (std::size_t e = 0; e < judged_.edges.edges.size(); ++e) {
      const edges::FeatureEdge& edge = judged_.edges.edges[e];
      const world::Placed& placed = judged_.world.models[static_cast<std::size_t>(edge.model)];
      if (edge.kind != EdgeKind::contour || edge.mesh_edge < 0 || placed.part != nullptr || edge.by_chance) continue;
      const std::span<const int> beside =
          placed.mesh->triangles_of(placed.mesh->edges[static_cast<std::size_t>(edge.mesh_edge)]);
      const int first = judged_.world.first_triangle[static_cast<std::size_t>(edge.model)];
      if (beside.size() != 2 || !is_inside(placed, edge.mesh_edge, {first + beside[0], first + beside[1]})) continue;
      if (std::none_of(beside.begin(), beside.end(), [&](int one) { return is_saddle(edge.model, one); })) continue;
      const Vec2 along = place_of(edge.vertex[1]) - place_of(edge.vertex[0]);
      double off = glm::length(along);
      for (const int one : beside)
        off =
            std::max(off, longest_side(first + one) * std::max(stretch_at(edge.vertex[0]), stretch_at(edge.vertex[1])));
      legs.push_back({edge.vertex[0], along, off, is_seen(e)});
      legs.push_back({edge.vertex[1], -along, off, is_seen(e)});
    }
    return legs;
  }

  // Whether the neighbours of a triangle on the same surface are folded to both of its sides.
  [[nodiscard]] bool is_saddle(int model, int triangle) const {
    const world::Placed& placed = judged_.world.models[static_cast<std::size_t>(model)];
    const mesh::Mesh& mesh = *placed.mesh;
    const int first = judged_.world.first_triangle[static_cast<std::size_t>(model)];
    const int before = judged_.world.first_vertex[static_cast<std::size_t>(model)];
    const std::array<int, 3> corners = mesh.triangle(triangle);
    const Vec3 normal = normal_of(first + triangle);
    constexpr double flat = 1e-9;  // sine
    bool above = false, below = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      const std::array<int, 2> ends{low, high};
      const mesh::MeshEdge* side = mesh.edge_between(ends);
      if (side == nullptr || side->count != 2) continue;
      for (const int other : mesh.triangles_of(*side)) {
        if (other == triangle || !is_inside(placed, side - mesh.edges.data(), {first + triangle, first + other}))
          continue;
        for (const int corner : mesh.triangle(other)) {
          const Vec3 to = judged_.world.points[before + corner] - judged_.world.points[before + ends[0]];
          const double rise = glm::dot(normal, to), slack = flat * glm::length(normal) * glm::length(to);
          above = above || rise > slack;
          below = below || rise < -slack;
        }
      }
    }
    return above && below;
  }
};

}  // namespace

double off_at_cusps(const ViewToJudge& judged) { return judged.is_whole ? EndsOfTriangles(judged).off() : 0; }

}  // namespace epura::accuracy
