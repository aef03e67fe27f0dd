// SPDX-License-Identifier: Apache-2.0
#include "accuracy/contour_ends.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "accuracy/judged_view.hpp"
#include "accuracy/seen_ink.hpp"

namespace epura::accuracy {

namespace {

class ContourEnds : JudgedView {
 public:
  using JudgedView::JudgedView;

  /// Where a surface curves both ways, its contour may end in a cusp, which facets do not have: theirs turns back
  /// there, by a side of a facet too early or too late. It also turns back where it goes on: then there are other lines
  /// beside it, and it is off no farther than these are. Contours drawn on the surface have their own measure.
  [[nodiscard]] double at_cusps() const {
    if (!judged_.is_whole) return 0;
    std::vector<Leg> legs = legs_of_saddles();
    if (legs.empty()) return 0;
    const std::vector<char> rims = vertices_of_rims();
    std::erase_if(legs, [&](const Leg& leg) { return rims[static_cast<std::size_t>(leg.from)] != 0; });
    std::stable_sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) { return a.from < b.from; });
    double largest = 0;
    std::vector<const Leg*> turning;
    for (std::size_t i = 0; i < legs.size(); ++i)
      for (std::size_t j = i + 1; j < legs.size() && legs[j].from == legs[i].from; ++j) {
        if (!(glm::dot(legs[i].along, legs[j].along) > 0)) continue;
        for (const Leg* leg : {&legs[i], &legs[j]})
          if (leg->is_seen && leg->is_known)
            turning.push_back(leg);
          else if (leg->is_seen)
            largest = std::max(largest, leg->off);
      }
    return turning.empty() ? largest : std::max(largest, off_other_lines(turning, largest));
  }

 private:
  /// A contour of facets, from one of its ends.
  struct Leg {
    int from;
    Vec2 along;     ///< on paper, mm
    double off;     ///< by which it may end too early or too late, mm
    bool is_seen;   ///< there; of an unknown surface, in part
    bool is_known;  ///< its surface
  };
  /// Where a line is visible.
  struct SeenEnds {
    std::array<bool, 2> at{};
    bool changes = false;  ///< in between
  };

  [[nodiscard]] SeenEnds seen_ends(std::size_t edge) const {
    SeenEnds seen;
    bool any = false, all = true;
    judged_.hidden.visit_parts(edge, [&](double from, double to, bool visible) {
      seen.at[0] = seen.at[0] || (visible && from == 0);
      seen.at[1] = seen.at[1] || (visible && to == 1);
      any = any || visible;
      all = all && visible;
    });
    seen.changes = any && !all;
    return seen;
  }

  // Those that are drawn where the facets are, on surfaces that curve both ways. A facet that is turned over by chance
  // has no contour of its surface.
  [[nodiscard]] std::vector<Leg> legs_of_saddles() const {
    std::vector<Leg> legs;
    for (std::size_t e = 0; e < judged_.edges.edges.size(); ++e) {
      const edges::FeatureEdge& edge = judged_.edges.edges[e];
      const bool is_drawn_there = edge.shown[0] < 0 && edge.shown[1] < 0 && !edge.by_chance;
      if (edge.kind != EdgeKind::contour || edge.mesh_edge < 0 || !is_drawn_there) continue;
      const world::Placed& placed = judged_.world.models[static_cast<std::size_t>(edge.model)];
      const std::span<const int> beside =
          placed.mesh->triangles_of(placed.mesh->edges[static_cast<std::size_t>(edge.mesh_edge)]);
      const int first = judged_.world.first_triangle[static_cast<std::size_t>(edge.model)];
      if (beside.size() != 2 || !is_inside(placed, edge.mesh_edge, {first + beside[0], first + beside[1]})) continue;
      if (std::none_of(beside.begin(), beside.end(), [&](int one) { return is_saddle(edge.model, one); })) continue;
      const Vec2 along = place_of(edge.vertex[1]) - place_of(edge.vertex[0]);
      const SeenEnds seen = seen_ends(e);
      const bool is_known = placed.part != nullptr;
      const bool in_part = !is_known && (seen.at[0] || seen.at[1] || seen.changes);
      double off = glm::length(along);
      // Whole facets of an unknown surface face the wrong way.
      if (placed.part == nullptr)
        for (const int one : beside)
          off = std::max(off,
                         longest_side(first + one) * std::max(stretch_at(edge.vertex[0]), stretch_at(edge.vertex[1])));
      legs.push_back({edge.vertex[0], along, off, seen.at[0] || in_part, is_known});
      legs.push_back({edge.vertex[1], -along, off, seen.at[1] || in_part, is_known});
    }
    return legs;
  }

  // By how much legs may end too early or too late where no other lines are: at most by their length. Less than `known`
  // does not matter.
  [[nodiscard]] double off_other_lines(std::vector<const Leg*> legs, double known) const {
    std::stable_sort(legs.begin(), legs.end(), [](const Leg* a, const Leg* b) { return a->off > b->off; });
    const SeenInk ink(judged_);
    double largest = known;
    for (const Leg* leg : legs) {
      if (!(leg->off > largest)) break;
      largest = ink.farthest_from_others({leg->from, leg->along}, largest);
    }
    return largest;
  }

  // By vertex: whether a surface ends there, and contours with it.
  [[nodiscard]] std::vector<char> vertices_of_rims() const {
    std::vector<char> rims(judged_.view.vertices.size(), 0);
    for (std::size_t m = 0; m < judged_.world.models.size(); ++m) {
      const world::Placed& placed = judged_.world.models[m];
      const int first = judged_.world.first_triangle[m], before = judged_.world.first_vertex[m];
      for (std::size_t e = 0; e < placed.mesh->edges.size(); ++e) {
        const std::span<const int> beside = placed.mesh->triangles_of(placed.mesh->edges[e]);
        if (beside.size() == 2 && (placed.part == nullptr || is_inside(placed, static_cast<std::ptrdiff_t>(e),
                                                                       {first + beside[0], first + beside[1]})))
          continue;
        for (const int vertex : placed.mesh->edges[e].vertex) rims[static_cast<std::size_t>(before + vertex)] = 1;
      }
    }
    return rims;
  }

  // Planes, cylinders, cones and spheres curve one way.
  static bool may_be_saddle(const surfaces::PartFaces& part, int triangle) {
    const int face = part.face_of_triangle[static_cast<std::size_t>(triangle)];
    if (face < 0) return true;
    const surfaces::SurfaceKind kind = part.faces[static_cast<std::size_t>(face)].surface.kind;
    return kind == surfaces::SurfaceKind::torus || kind == surfaces::SurfaceKind::free_form;
  }

  // Whether the neighbours of a triangle on the same surface are folded to both of its sides.
  [[nodiscard]] bool is_saddle(int model, int triangle) const {
    const world::Placed& placed = judged_.world.models[static_cast<std::size_t>(model)];
    const mesh::Mesh& mesh = *placed.mesh;
    if (placed.part != nullptr && !may_be_saddle(*placed.part, triangle)) return false;
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

double off_at_cusps(const ViewToJudge& judged) { return ContourEnds(judged).at_cusps(); }

}  // namespace epura::accuracy
