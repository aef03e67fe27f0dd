// SPDX-License-Identifier: Apache-2.0
#include "mesh/t_vertices.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vec.hpp"
#include "mesh/cracks.hpp"
#include "search/bounds_tree.hpp"
#include "search/halved_order.hpp"

namespace epura::mesh {

namespace {

constexpr std::size_t edges_a_look = 256;
// On average: more lie on edges only where many of these coincide, which do not belong together then.
constexpr std::size_t most_on_an_edge = 64;

/// Where triangles meet in a line, their number is even; elsewhere an edge is loose.
bool is_loose(const MeshEdge& edge) { return edge.count % 2 == 1; }

/// Whether a box has points within `margin` of a line, measured along the axes.
bool may_reach(const search::Bounds<3>& box, const std::array<Vec3, 2>& line, double margin) {
  double from = 0, to = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double begin = line[0][axis], step = line[1][axis] - begin;
    const double low = box[axis][0] - margin - begin, high = box[axis][1] + margin - begin;
    if (step == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    from = std::max(from, std::min(low / step, high / step));
    to = std::min(to, std::max(low / step, high / step));
  }
  return from <= to;
}

/// A loose edge and the vertices on it, from its lower end to its upper one.
struct DividedEdge {
  int edge;
  std::vector<int> chain;
};

/// The ends of loose edges.
class LooseEnds {
 public:
  LooseEnds(const Points& points, const EdgeTable& table) : points_(points) {
    for (const MeshEdge& edge : table.edges)
      if (is_loose(edge)) ends_.insert(ends_.end(), edge.vertex.begin(), edge.vertex.end());
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    search::order_by_halving(ends_.begin(), ends_.end(), [&](int vertex) { return place(vertex); });
    tree_ = {ends_.size(), [&](std::size_t i) {
               const Vec3 p = place(ends_[i]);
               return search::Bounds<3>{{{p.x, p.x}, {p.y, p.y}, {p.z, p.z}}};
             }};
  }

  /// The ends of an edge and those on it.
  [[nodiscard]] std::vector<int> chain_of(const MeshEdge& edge, double width) const {
    const std::array<Vec3, 2> line{place(edge.vertex[0]), place(edge.vertex[1])};
    const double length = glm::distance(line[0], line[1]);
    std::vector<std::pair<double, int>> found;  // by the distance along the edge
    const auto look_at = [&](std::size_t i) {
      if (ends_[i] == edge.vertex[0] || ends_[i] == edge.vertex[1]) return true;
      const Vec3 from_begin = place(ends_[i]) - line[0], direction = (line[1] - line[0]) / length;
      const double along = glm::dot(from_begin, direction), beside = glm::length(glm::cross(from_begin, direction));
      if (beside <= width && beside < widest_crack * std::min(along, length - along))
        found.emplace_back(along, ends_[i]);
      return true;
    };
    tree_.visit_where([&](const search::Bounds<3>& box) { return may_reach(box, line, width); }, look_at);
    std::sort(found.begin(), found.end());
    std::vector<int> chain{edge.vertex[0]};
    for (const auto& [along, vertex] : found) chain.push_back(vertex);
    chain.push_back(edge.vertex[1]);
    return chain;
  }

 private:
  [[nodiscard]] Vec3 place(int vertex) const { return {points_[vertex][0], points_[vertex][1], points_[vertex][2]}; }

  const Points& points_;
  std::vector<int> ends_;  ///< in the order of the tree
  search::BoundsTree<3> tree_;
};

/// A part of an edge, and the triangle beside that; of edges of several triangles, what no other edge has.
struct Part {
  int low, high, side;

  auto operator<=>(const Part&) const = default;
};

/// The parts of all edges, each once for each of its sides.
class Parts {
 public:
  Parts(const std::vector<DividedEdge>& edges, const EdgeTable& table) {
    for (const DividedEdge& edge : edges) {
      const auto halfedges = table.halfedges_of(table.edges[edge.edge]);
      const int side = halfedges.size() == 1 ? halfedges.front() / 3 : -1 - edge.edge;
      for (std::size_t i = 1; i < edge.chain.size(); ++i) {
        const auto [low, high] = std::minmax({edge.chain[i - 1], edge.chain[i]});
        parts_.push_back({low, high, side});
      }
    }
    std::sort(parts_.begin(), parts_.end());
    parts_.erase(std::unique(parts_.begin(), parts_.end()), parts_.end());
  }

  /// Whether something else than one triangle has the part.
  [[nodiscard]] bool meet_between(int a, int b) const {
    const auto [low, high] = std::minmax({a, b});
    const auto begin = std::lower_bound(parts_.begin(), parts_.end(), Part{low, high, INT_MIN});
    return parts_.end() - begin > 1 && begin[1].low == low && begin[1].high == high;
  }

 private:
  std::vector<Part> parts_;
};

/// Removes the vertices beside which no part of their edge is also a part of another edge, and then undivided edges.
void keep_where_edges_meet(std::vector<DividedEdge>& edges, const EdgeTable& table) {
  const Parts parts(edges, table);
  for (DividedEdge& edge : edges) {
    const std::vector<int>& chain = edge.chain;
    std::vector<int> kept{chain.front()};
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
      if (parts.meet_between(chain[i - 1], chain[i]) || parts.meet_between(chain[i], chain[i + 1]))
        kept.push_back(chain[i]);
    kept.push_back(chain.back());
    edge.chain = std::move(kept);
  }
  std::erase_if(edges, [](const DividedEdge& edge) { return edge.chain.size() == 2; });
}

std::vector<DividedEdge> divided_edges(const Points& points, const EdgeTable& table, double width,
                                       const Progress& progress) {
  std::vector<DividedEdge> edges;
  for (std::size_t e = 0; e < table.edges.size(); ++e)
    if (is_loose(table.edges[e])) edges.push_back({static_cast<int>(e), {}});
  const LooseEnds ends(points, table);
  const std::size_t most = (2 + most_on_an_edge) * edges.size();
  std::atomic<std::size_t> found = 0;
  parallel_for(edges.size(), edges_a_look, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && found <= most; ++i) {
      edges[i].chain = ends.chain_of(table.edges[edges[i].edge], width);
      found += edges[i].chain.size();
    }
  });
  if (found > most) return {};
  keep_where_edges_meet(edges, table);
  return edges;
}

/// What is between the ends of a side of a triangle.
struct DividedSide {
  int halfedge;
  std::vector<int> inside;
};

std::vector<DividedSide> divided_sides(const std::vector<DividedEdge>& edges, const EdgeTable& table,
                                       const std::vector<int>& corners) {
  std::vector<DividedSide> sides;
  for (const DividedEdge& edge : edges)
    for (const int halfedge : table.halfedges_of(table.edges[edge.edge])) {
      sides.push_back({halfedge, {edge.chain.begin() + 1, edge.chain.end() - 1}});
      if (corners[halfedge] != edge.chain.front()) std::reverse(sides.back().inside.begin(), sides.back().inside.end());
    }
  std::sort(sides.begin(), sides.end(),
            [](const DividedSide& a, const DividedSide& b) { return a.halfedge < b.halfedge; });
  return sides;
}

}  // namespace

int insert_t_vertices(Faces& triangles, const Points& points, const EdgeTable& table, double width,
                      const Progress& progress) {
  const std::vector<DividedEdge> edges = divided_edges(points, table, width, progress);
  if (edges.empty()) return 0;
  const std::vector<DividedSide> sides = divided_sides(edges, table, triangles.corners);
  Faces faces{.corners = {}, .ends = {}, .number = std::move(triangles.number)};
  auto next = sides.begin();
  for (int t = 0; t < static_cast<int>(faces.number.size()); ++t) {
    const auto begin = next;
    while (next != sides.end() && next->halfedge / 3 == t) ++next;
    // A ring that begins opposite to its only divided side is a fan.
    int halfedge = begin == next ? 3 * t : next_in_triangle(next_in_triangle(begin->halfedge));
    for (int k = 0; k < 3; ++k, halfedge = next_in_triangle(halfedge)) {
      faces.corners.push_back(triangles.corners[halfedge]);
      for (auto side = begin; side != next; ++side)
        if (side->halfedge == halfedge)
          faces.corners.insert(faces.corners.end(), side->inside.begin(), side->inside.end());
    }
    faces.ends.push_back(static_cast<int>(faces.corners.size()));
  }
  triangles = std::move(faces);
  return static_cast<int>(edges.size());
}

}  // namespace epura::mesh
