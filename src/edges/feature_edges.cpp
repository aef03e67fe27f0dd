#include "edges/feature_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/parallel.hpp"
#include "edges/dihedral.hpp"
#include "edges/tangent_edges.hpp"

namespace epura {

namespace {

// So that a threshold of 360/N takes all edges of an N-sided prism or none.
constexpr double angle_rounding = 1e-6;
// Corners this many cells from the line of an edge are on it: both ends and the corner were rounded to the grid.
constexpr double edge_on_cells = 2;
// Triangles lower than this part of the scene have no reliable normal.
constexpr double sliver_part = 0x1p-40;

struct Judge {
  EdgeSurroundings around;
  const View& view;
  const EdgeWishes& wishes;
  const std::vector<char>& is_sliver;   ///< by triangle
  const std::vector<char>& is_tangent;  ///< by edge; empty where nobody asks
  FoldLimit crease;
  double edge_on;  ///< cells from the line of an edge within which a corner is on it

  [[nodiscard]] Beyond beyond_slivers(const std::array<int, 2>& edge, int triangle) const {
    return is_sliver[triangle] != 0 ? across_slivers(around, edge, triangle) : Beyond{triangle, false};
  }

  [[nodiscard]] const Mesh& mesh() const { return *around.world.models[around.model].mesh; }

  // Where the third corner of a triangle lies: 1 left of the edge on the page, -1 right, 0 on its line.
  [[nodiscard]] int side(const std::array<int, 2>& edge, int triangle) const {
    const int corner = around.apex(edge, triangle);
    if (view.triangle_planes.empty()) return side_on_grid(edge, corner);
    const bool before_viewer = is_before_viewer(edge[0]) && is_before_viewer(edge[1]) && is_before_viewer(corner);
    return before_viewer ? side_on_page(edge, corner) : side_in_space(edge, corner);
  }

  // Far enough from the plane of the viewer for places on the page to keep their digits.
  [[nodiscard]] bool is_before_viewer(int vertex) const { return view.clipper.vertices[vertex].w > 0x1p-20; }

  // Without the grid, for corners that may lie beyond the window.
  [[nodiscard]] int side_on_page(const std::array<int, 2>& edge, int corner) const {
    const auto place = [this](int v) { return Vec2(view.vertices[v].x, view.vertices[v].y); };
    const Vec2 along = place(edge[1]) - place(edge[0]), to = place(corner) - place(edge[0]);
    const double area = along.x * to.y - along.y * to.x;
    const double rounding = 0x1p-44 * glm::length(to);
    return std::abs(area) <= (edge_on * view.cell + rounding) * glm::length(along) ? 0 : area > 0 ? 1 : -1;
  }

  [[nodiscard]] int side_on_grid(const std::array<int, 2>& edge, int corner) const {
    const GridPoint& a = view.grid[edge[0]];
    const GridPoint& b = view.grid[edge[1]];
    const double area = static_cast<double>(cross(a, b, view.grid[corner]));
    const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
    // The way along the axes is longer, and found without a root: nearly always it is enough.
    const bool beside = std::abs(area) > edge_on * (std::abs(dx) + std::abs(dy));
    if (!beside && std::abs(area) <= edge_on * std::hypot(dx, dy)) return 0;
    return area > 0 ? 1 : -1;
  }

  // The same without division, for corners that may lie behind the viewer: the side of the plane through edge and eye.
  [[nodiscard]] int side_in_space(const std::array<int, 2>& edge, int corner) const {
    const Mapped& a = view.clipper.vertices[edge[0]];
    const Mapped& b = view.clipper.vertices[edge[1]];
    const Mapped& c = view.clipper.vertices[corner];
    const Vec3 normal = glm::cross(Vec3(a.x, a.y, a.w), Vec3(b.x, b.y, b.w));
    const double volume = glm::dot(normal, Vec3(c.x, c.y, c.w));
    const double rounding = 0x1p-44 * glm::length(normal) * glm::length(Vec3(c.x, c.y, c.w));
    return std::abs(volume) <= rounding ? 0 : volume > 0 ? 1 : -1;
  }

  // Two triangles at an edge.
  [[nodiscard]] std::optional<EdgeKind> judge_pair(const MeshEdge& edge, const std::array<int, 2>& ends, int first,
                                                   int second) const {
    const Beyond one = beyond_slivers(ends, first);
    const Beyond two = beyond_slivers(ends, second);
    if (one.covered || two.covered) return std::nullopt;
    if (!one.triangle || !two.triangle) return wish(EdgeKind::boundary);
    const int side_one = side(ends, *one.triangle);
    const int side_two = side(ends, *two.triangle);
    const bool contour = side_one == side_two ? side_one != 0 : side_one == 0 || side_two == 0;
    if (contour && wishes.contour) return EdgeKind::contour;
    // Inside a polygon nothing is folded: the file says it is one face.
    if (edge.diagonal) return std::nullopt;
    if (wishes.crease && folds_by(around, ends, *one.triangle, *two.triangle, crease)) return EdgeKind::crease;
    if (!is_tangent.empty() && is_tangent[static_cast<std::size_t>(&edge - mesh().edges.data())] != 0)
      return EdgeKind::tangent;
    return wish(EdgeKind::smooth);
  }

  [[nodiscard]] std::optional<EdgeKind> wish(EdgeKind kind) const {
    const bool wanted = kind == EdgeKind::boundary ? wishes.boundary
                        : kind == EdgeKind::crease ? wishes.crease
                                                   : wishes.smooth;
    return wanted ? std::optional(kind) : std::nullopt;
  }

  // Triangles of one body at an edge.
  [[nodiscard]] std::optional<EdgeKind> judge_body(const MeshEdge& edge, const std::array<int, 2>& ends,
                                                   const std::vector<int>& triangles) const {
    if (triangles.size() == 1) return wish(EdgeKind::boundary);
    if (triangles.size() == 2) return judge_pair(edge, ends, triangles[0], triangles[1]);
    return wish(EdgeKind::crease);
  }

  [[nodiscard]] std::optional<EdgeKind> judge(const MeshEdge& edge) const {
    if (edge.cut == CutEdge::inside) return std::nullopt;
    if (edge.cut == CutEdge::outline) return EdgeKind::section;
    const int first = around.world.first_vertex[around.model];
    const std::array<int, 2> ends{first + edge.vertex[0], first + edge.vertex[1]};
    const auto all = mesh().triangles_of(edge);
    if (all.size() == 2) return judge_pair(edge, ends, all[0], all[1]);

    // Bodies that touch in an edge are judged each by itself; the strongest reason wins.
    std::optional<EdgeKind> strongest;
    std::vector<int> triangles(all.begin(), all.end());
    std::stable_sort(triangles.begin(), triangles.end(), [&](int a, int b) { return mesh().body[a] < mesh().body[b]; });
    for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
      while (end < triangles.size() && mesh().body[triangles[end]] == mesh().body[triangles[begin]]) ++end;
      const auto kind = judge_body(edge, ends, {triangles.begin() + begin, triangles.begin() + end});
      if (kind && (!strongest || *kind < *strongest)) strongest = kind;
    }
    return strongest;
  }
};

}  // namespace

std::vector<std::optional<EdgeKind>> feature_edges(const World& world, const View& view, int model,
                                                   const EdgeWishes& wishes, const Progress& progress) {
  const EdgeSurroundings around{world, model, view.map.shrink, std::max(sliver_part, world.rounding * view.map.shrink)};
  std::vector<char> is_sliver(world.models[model].mesh->polygon.size());
  parallel_for(is_sliver.size(), 8192, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      is_sliver[t] = height_of(around, static_cast<int>(t)) <= around.sliver ? 1 : 0;
  });
  const std::vector<char> is_tangent =
      wishes.tangent ? tangent_edges(around, wishes.crease_angle - angle_rounding) : std::vector<char>();
  const Judge judge{around,
                    view,
                    wishes,
                    is_sliver,
                    is_tangent,
                    FoldLimit(wishes.crease_angle - angle_rounding),
                    std::max(edge_on_cells, world.rounding * view.map.shrink * view.map.unit / view.cell)};
  const auto& edges = judge.mesh().edges;
  std::vector<std::optional<EdgeKind>> kinds(edges.size());
  parallel_for(edges.size(), 4096, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) kinds[e] = judge.judge(edges[e]);
    progress.advance(end - begin);
  });
  return kinds;
}

}  // namespace epura
