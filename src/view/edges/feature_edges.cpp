// SPDX-License-Identifier: Apache-2.0
#include "edges/feature_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "edges/dihedral.hpp"
#include "edges/limits.hpp"
#include "edges/slivers.hpp"
#include "edges/tangent_edges.hpp"
#include "edges/walls.hpp"
#include "refine/facing.hpp"
#include "view/page_height.hpp"
#include "world/placed_part.hpp"

namespace epura::edges {

namespace {

// Twice the vector areas of the polygons of the file, by number: normals of polygons that need not be flat (Newell).
// Empty if all polygons are triangles.
std::vector<Vec3> mean_normals(const EdgeSurroundings& around) {
  const mesh::Mesh& mesh = around.mesh();
  if (std::none_of(mesh.edges.begin(), mesh.edges.end(), [](const mesh::MeshEdge& e) { return e.diagonal; })) return {};
  std::vector<Vec3> sums(static_cast<std::size_t>(*std::max_element(mesh.polygon.begin(), mesh.polygon.end())) + 1);
  for (std::size_t t = 0; t < mesh.polygon.size(); ++t) {
    check(mesh.polygon[t] >= 0, "every triangle is of a polygon of the file");
    const std::array<int, 3> c = around.corners(static_cast<int>(t));
    const Vec3 a = around.point(c[0]);
    sums[mesh.polygon[t]] += glm::cross(around.point(c[1]) - a, around.point(c[2]) - a);
  }
  return sums;
}

// By number: whether a vertex that a cut created was moved off its edge (cut/true_outline.hpp). Empty without a cut.
std::vector<char> moved_vertices(const EdgeSurroundings& around) {
  const world::Placed& placed = around.world.models[around.model];
  const mesh::Mesh& cut = *placed.mesh;
  if (around.uncut == nullptr || placed.part == nullptr) return {};
  std::vector<char> moved(cut.points.size(), 0);
  for (std::size_t i = 0; i < cut.cut_vertices.size(); ++i) {
    const mesh::CutVertex& vertex = cut.cut_vertices[i];
    if (vertex.edge[0] < 0) continue;
    const auto point = [&](int v) { return around.world.points[around.world.first_vertex[around.model] + v]; };
    const Vec3 a = point(vertex.edge[0]), b = point(vertex.edge[1]);
    const int number = cut.first_cut_vertex + static_cast<int>(i);
    const double off = glm::distance(point(number), a + vertex.t * (b - a));
    moved[number] = off > place_rounding * std::max(glm::length(a), glm::length(b)) ? 1 : 0;
  }
  return moved;
}

// How far a triangle may be off the plane of its neighbour and still lie in it. Where faces of a part are recognised,
// this is what vertices may be off them: needles folded back in a face are no better than its vertices.
double flat_within(const EdgeSurroundings& around) {
  const world::Placed& placed = around.world.models[static_cast<std::size_t>(around.model)];
  double distance = around.world.rounding;
  if (placed.part != nullptr)
    if (const auto scale = world::similarity_scale(placed.to_world))
      distance = std::max(distance, placed.part->tolerance * *scale);
  return std::max(flatness, distance * around.normalisation);
}

/// The triangles that decide about an edge, with their corners beside it and their normals there.
struct Pair {
  int first, second;
  std::array<int, 2> apexes;
  std::array<Vec3, 2> normals;
};

struct EdgeJudge {
  EdgeSurroundings around;
  const view::ProjectedScene& view;
  const EdgeOptions& options;
  const Slivers& slivers;
  const std::vector<char>& is_tangent;       ///< by edge; empty if not needed
  const std::vector<Vec3>& polygon_normals;  ///< by polygon number
  FoldLimit crease;
  const surfaces::PartFaces* part;  ///< null if no faces are recognised
  const std::vector<char>& walls;   ///< by face of the part
  double edge_on;                   ///< distance in cells up to which a corner counts as lying on the line of an edge
  double edge_on_grid;              ///< the same for vertices that files do not round
  const std::vector<char>& moved;   ///< moved_vertices
  double flat;                      ///< flat_within

  [[nodiscard]] const mesh::Mesh& mesh() const { return around.mesh(); }

  // The side of the edge on which the third corner of a triangle lies on the page: 1 left, -1 right, 0 on its line or
  // no farther than `reach` cells from it.
  [[nodiscard]] int side(const std::array<int, 2>& edge, int triangle, double reach) const {
    return side_of(edge, around.apex(edge, triangle), reach);
  }

  [[nodiscard]] int side_of(const std::array<int, 2>& edge, int corner, double reach) const {
    // Corners that a clipping plane removes may lie anywhere.
    if (view.triangle_planes.empty() && around.uncut == nullptr) return side_on_grid(edge, corner, reach);
    const bool before_viewer = is_before_viewer(edge[0]) && is_before_viewer(edge[1]) && is_before_viewer(corner);
    return before_viewer ? side_on_page(edge, corner, reach) : side_in_space(edge, corner);
  }

  // The same of a triangle at the edge, as its surface tells if that is known.
  [[nodiscard]] int side_at(const std::array<int, 2>& edge, int triangle, int apex, double reach) const {
    if (const int facing = around.facing_of(triangle); facing != 0) {
      const std::array<int, 3> c = around.corners(triangle);
      for (std::size_t i = 0; i < 3; ++i) {
        if (c[i] == edge[0] && c[(i + 1) % 3] == edge[1]) return facing;
        if (c[i] == edge[1] && c[(i + 1) % 3] == edge[0]) return -facing;
      }
    }
    return side_of(edge, apex, reach);
  }

  [[nodiscard]] bool is_of_wall(int triangle) const {
    return part != nullptr && walls[static_cast<std::size_t>(part->face_of_triangle[triangle])] != 0;
  }

  // Whether two triangles are of one face that curves both ways, and whose surface is known: its contour is moved to
  // the surface, wherever files round the vertices.
  [[nodiscard]] bool are_of_smooth_face(int one, int other) const {
    if (part == nullptr || part->face_of_triangle[one] != part->face_of_triangle[other]) return false;
    const auto face = static_cast<std::size_t>(part->face_of_triangle[one]);
    const surfaces::SurfaceKind kind = part->faces[face].surface.kind;
    return kind == surfaces::SurfaceKind::sphere || kind == surfaces::SurfaceKind::torus;
  }

  // Whether two triangles lie in one plane face, one of them a needle as low as corners are off the face, above and
  // below: whatever side of it is seen, and wherever it is folded to, a plane has no contour.
  [[nodiscard]] bool are_of_plane_with_needle(int one, int other) const {
    if (part == nullptr || part->face_of_triangle[one] != part->face_of_triangle[other]) return false;
    const auto face = static_cast<std::size_t>(part->face_of_triangle[one]);
    return part->faces[face].surface.kind == surfaces::SurfaceKind::plane &&
           std::min(height_of(around, one), height_of(around, other)) <= 2 * flat;
  }

  // Whether every corner of a triangle lies on the line of the opposite side.
  [[nodiscard]] bool is_edge_on(int triangle, double reach) const {
    const std::array<int, 3> c = around.corners(triangle);
    for (int i = 0; i < 3; ++i)
      if (side({c[i], c[(i + 1) % 3]}, triangle, reach) != 0) return false;
    return true;
  }

  // Whether the edge is a contour: both triangles lie on one side of it, or one of them is seen edge-on. A triangle
  // whose third corner is on the line of this edge may still face the viewer at its other sides, so between two such
  // triangles the sign decides, however small; otherwise the contour would have a gap there.
  [[nodiscard]] bool is_contour(const std::array<int, 2>& edge, const Pair& pair) const {
    const double reach = are_of_smooth_face(pair.first, pair.second) ? edge_on_grid : edge_on;
    const bool wall_one = is_of_wall(pair.first), wall_two = is_of_wall(pair.second);
    const int side_one = wall_one ? 0 : side_at(edge, pair.first, pair.apexes[0], reach);
    const int side_two = wall_two ? 0 : side_at(edge, pair.second, pair.apexes[1], reach);
    if (side_one != side_two) return side_one == 0 || side_two == 0;
    if (side_one != 0) return true;
    const bool first_edge_on = wall_one || is_edge_on(pair.first, reach);
    const bool second_edge_on = wall_two || is_edge_on(pair.second, reach);
    if (first_edge_on || second_edge_on) return first_edge_on != second_edge_on;
    const int sign = side_of(edge, pair.apexes[0], 0);
    return sign != 0 && sign == side_of(edge, pair.apexes[1], 0);
  }

  // Far enough in front of the viewer for positions on the page to keep their precision.
  [[nodiscard]] bool is_before_viewer(int vertex) const { return view.clipper.vertices[vertex].w > 0x1p-20; }

  // The same without the grid, for corners that may lie outside the window.
  [[nodiscard]] int side_on_page(const std::array<int, 2>& edge, int corner, double reach) const {
    const auto place = [this](int v) { return Vec2(view.vertices[v].x, view.vertices[v].y); };
    const Vec2 along = place(edge[1]) - place(edge[0]), to = place(corner) - place(edge[0]);
    const double area = cross(along, to);
    const double rounding = 0x1p-44 * glm::length(to);
    return std::abs(area) <= (reach * view.cell + rounding) * glm::length(along) ? 0 : area > 0 ? 1 : -1;
  }

  [[nodiscard]] int side_on_grid(const std::array<int, 2>& edge, int corner, double reach) const {
    const view::GridPoint& a = view.grid[edge[0]];
    const view::GridPoint& b = view.grid[edge[1]];
    const double area = static_cast<double>(view::cross(a, b, view.grid[corner]));
    const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
    // The 1-norm is at least as large as the length, needs no square root, and nearly always decides.
    const bool beside = std::abs(area) > reach * (std::abs(dx) + std::abs(dy));
    if (!beside && std::abs(area) <= reach * std::hypot(dx, dy)) return 0;
    return area > 0 ? 1 : -1;
  }

  // The same without division, for corners that may lie behind the viewer: the side of the plane through the edge and
  // the centre of projection.
  [[nodiscard]] int side_in_space(const std::array<int, 2>& edge, int corner) const {
    const view::Mapped& a = view.clipper.vertices[edge[0]];
    const view::Mapped& b = view.clipper.vertices[edge[1]];
    const view::Mapped& c = view.clipper.vertices[corner];
    const Vec3 normal = glm::cross(Vec3(a.x, a.y, a.w), Vec3(b.x, b.y, b.w));
    const double volume = glm::dot(normal, Vec3(c.x, c.y, c.w));
    const double rounding = 0x1p-44 * glm::length(normal) * glm::length(Vec3(c.x, c.y, c.w));
    return std::abs(volume) <= rounding ? 0 : volume > 0 ? 1 : -1;
  }

  // Whether the second triangle is folded back over the first one in its plane, given their normals at the edge.
  [[nodiscard]] bool is_folded_over(const std::array<int, 2>& edge, const std::array<Vec3, 2>& normals) const {
    const auto& [n1, n2] = normals;
    if (!(glm::dot(n1, n2) < 0)) return false;
    const double height = glm::length(n2) / glm::length(around.point(edge[1]) - around.point(edge[0]));
    const double sine = glm::length(glm::cross(n1, n2)) / (glm::length(n1) * glm::length(n2));
    return sine * height <= flat;
  }

  // The triangle that continues the surface if the triangle at the edge is folded over and the next one is folded back
  // again: three layers in one plane, which need no line.
  [[nodiscard]] std::optional<int> behind_pleat(const std::array<int, 2>& edge, int triangle, int folded) const {
    if (!is_folded_over(edge, normals_at(around, edge, triangle, folded))) return std::nullopt;
    const auto [side, next] = slivers.way_out(edge, folded);
    if (!next) return std::nullopt;
    const auto [n1, n2] = normals_at(around, edge, triangle, *next);
    if (!is_folded_over(side, normals_at(around, side, *next, folded)) || !(glm::dot(n1, n2) > 0)) return std::nullopt;
    return ends_in_its_plane(folded, edge, side) ? next : std::nullopt;
  }

  // Whether the third side of a pleat is short, or the surface is folded back there as well; otherwise the pleat sticks
  // out.
  [[nodiscard]] bool ends_in_its_plane(int folded, const std::array<int, 2>& one,
                                       const std::array<int, 2>& other) const {
    const std::array<int, 3> corners = around.corners(folded);
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % 3]);
      const std::array<int, 2> third{a, b};
      if (third == one || third == other) continue;
      if (glm::length(around.point(b) - around.point(a)) <= 2 * height_of(around, folded)) return true;
      const mesh::MeshEdge* edge = find_edge(around, third);
      if (edge == nullptr || edge->count != 2) return false;
      const auto both = mesh().triangles_of(*edge);
      return is_folded_over(third, normals_at(around, third, both[0] == folded ? both[1] : both[0], folded));
    }
    return true;
  }

  [[nodiscard]] Pair plain_pair(const std::array<int, 2>& ends, int first, int second) const {
    const std::array<int, 2> apexes{around.apex(ends, first), around.apex(ends, second)};
    return {first, second, apexes, normals_beside(around, ends, apexes)};
  }

  [[nodiscard]] Pair pair_at(const std::array<int, 2>& ends, int first, int second) const {
    const Pair plain = plain_pair(ends, first, second);
    const bool is_told = around.facing_of(first) != 0 || around.facing_of(second) != 0;
    if (is_told || !(glm::dot(plain.normals[0], plain.normals[1]) < 0)) return plain;
    if (const auto next = behind_pleat(ends, first, second)) return plain_pair(ends, first, *next);
    if (const auto next = behind_pleat(ends, second, first)) return plain_pair(ends, *next, second);
    return plain;
  }

  // The kind of an edge between two triangles.
  [[nodiscard]] std::optional<EdgeKind> judge_pair(const mesh::MeshEdge& edge, const std::array<int, 2>& ends,
                                                   int first, int second) const {
    const std::optional<EdgeKind> border = kind_of_border(edge);
    const Beyond one = slivers.beyond(ends, first);
    const Beyond two = slivers.beyond(ends, second);
    // One of the two sides of a sliver between faces of the part is their border.
    if (one.covered || two.covered) return border == EdgeKind::crease ? if_wanted(EdgeKind::crease) : std::nullopt;
    if (!one.triangle || !two.triangle) return if_wanted(EdgeKind::boundary);
    const Pair pair = pair_at(ends, *one.triangle, *two.triangle);
    if (options.contour && is_contour(ends, pair) && !are_of_plane_with_needle(first, second)) return EdgeKind::contour;
    // A polygon of the file is one face, so its diagonals are not drawn.
    if (edge.diagonal) return std::nullopt;
    if (part != nullptr) return border && if_wanted(*border) ? border : if_wanted(EdgeKind::smooth);
    if (options.crease && folds_by(normals_of_faces(pair), crease)) return EdgeKind::crease;
    if (!is_tangent.empty() && is_tangent[static_cast<std::size_t>(&edge - mesh().edges.data())] != 0)
      return EdgeKind::tangent;
    return if_wanted(EdgeKind::smooth);
  }

  // The kind of an edge between faces of the part; nothing inside a face.
  [[nodiscard]] std::optional<EdgeKind> kind_of_border(const mesh::MeshEdge& edge) const {
    if (part == nullptr) return std::nullopt;
    const surfaces::PartBorder* border = part->border_at(&edge - mesh().edges.data());
    if (border == nullptr) return std::nullopt;
    return border->angle > options.part_angle ? EdgeKind::crease : EdgeKind::tangent;
  }

  // The normals of the polygons to which the triangles belong, oriented like those of the triangles.
  [[nodiscard]] std::array<Vec3, 2> normals_of_faces(const Pair& pair) const {
    std::array<Vec3, 2> normals = pair.normals;
    if (polygon_normals.empty()) return normals;
    const std::array<int, 2> triangles{pair.first, pair.second};
    for (int i = 0; i < 2; ++i) {
      const Vec3& mean = polygon_normals[mesh().polygon[triangles[i]]];
      const double turned = glm::dot(mean, normals[i]);
      if (turned != 0) normals[i] = turned > 0 ? mean : -mean;
    }
    return normals;
  }

  [[nodiscard]] std::optional<EdgeKind> if_wanted(EdgeKind kind) const {
    const bool wanted = kind == EdgeKind::boundary  ? options.boundary
                        : kind == EdgeKind::crease  ? options.crease
                        : kind == EdgeKind::tangent ? options.tangent
                        : kind == EdgeKind::wire    ? options.wire
                                                    : options.smooth;
    return wanted ? std::optional(kind) : std::nullopt;
  }

  // The kind of an edge, judged by the triangles of one body.
  [[nodiscard]] std::optional<EdgeKind> judge_body(const mesh::MeshEdge& edge, const std::array<int, 2>& ends,
                                                   const std::vector<int>& triangles) const {
    if (triangles.size() == 1) return if_wanted(EdgeKind::boundary);
    if (triangles.size() == 2) return judge_pair(edge, ends, triangles[0], triangles[1]);
    return if_wanted(EdgeKind::crease);
  }

  // A line of the file is drawn as such unless the faces give a stronger reason.
  [[nodiscard]] std::optional<EdgeKind> kind_of(const mesh::MeshEdge& edge) const {
    const std::optional<EdgeKind> kind = kind_of_fold(edge);
    const bool is_wire = edge.wire && options.wire && (!kind || *kind > EdgeKind::wire);
    return is_wire ? EdgeKind::wire : kind;
  }

  // The kind of an edge of the drawn mesh. A cut may leave only thin pieces of faces, so the remains of an edge are
  // judged by the uncut faces.
  [[nodiscard]] std::optional<EdgeKind> kind_of_fold(const mesh::MeshEdge& edge) const {
    if (edge.cut == mesh::CutEdge::outline) return EdgeKind::section;
    if (around.uncut == nullptr) return judge(edge);
    const std::optional<bool> contour = is_contour_of_remains(edge);
    if (edge.cut == mesh::CutEdge::inside)
      return contour.value_or(false) ? std::optional(EdgeKind::contour) : std::nullopt;
    const mesh::EdgeOrigin origin = around.world.models[around.model].mesh->origin_of(edge);
    const mesh::MeshEdge& whole = *find_edge(around, in_world(origin.vertex));
    const std::optional<EdgeKind> kind = judge(whole);
    if (!contour || (kind && *kind != EdgeKind::contour)) return kind;
    if (*contour) return EdgeKind::contour;
    const std::optional<EdgeKind> border = kind_of_border(whole);
    return border && if_wanted(*border) ? border : if_wanted(EdgeKind::smooth);
  }

  // Where a cut was moved onto the surface of the part, the remains of facets face elsewhere than the whole facets, and
  // decide themselves; so do those of which a surface tells how they turn. Nothing if neither holds, or if the remains
  // are too thin.
  [[nodiscard]] std::optional<bool> is_contour_of_remains(const mesh::MeshEdge& edge) const {
    if (moved.empty() || !options.contour || edge.count != 2) return std::nullopt;
    const mesh::Mesh& cut = *around.world.models[around.model].mesh;
    const auto triangles = cut.triangles_of(edge);
    const auto has_moved = [&](int triangle) {
      const std::array<int, 3> corners = cut.triangle(triangle);
      return std::any_of(corners.begin(), corners.end(), [&](int v) { return moved[v] != 0; });
    };
    EdgeJudge remains = *this;
    remains.around.uncut = nullptr;
    const auto decides = [&](int triangle) { return remains.around.facing_of(triangle) != 0 || has_moved(triangle); };
    if (!decides(triangles[0]) && !decides(triangles[1])) return std::nullopt;
    const std::array<int, 2> ends = in_world(edge.vertex);
    const auto side_of = [&](int triangle) {
      return remains.side_at(ends, triangle, remains.around.apex(ends, triangle), edge_on);
    };
    const int one = side_of(triangles[0]), two = side_of(triangles[1]);
    return one == 0 || two == 0 ? std::nullopt : std::optional(one == two);
  }

  [[nodiscard]] std::array<int, 2> in_world(const std::array<int, 2>& vertex) const {
    const int first = around.world.first_vertex[around.model];
    return {first + vertex[0], first + vertex[1]};
  }

  [[nodiscard]] std::optional<EdgeKind> judge(const mesh::MeshEdge& edge) const {
    const std::array<int, 2> ends = in_world(edge.vertex);
    const auto all = mesh().triangles_of(edge);
    if (all.size() == 2) return judge_pair(edge, ends, all[0], all[1]);

    // Bodies that touch in an edge are judged separately; the strongest reason wins.
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

// Hysteresis: of the edges that would be creases with the weak angle, those that are connected to a crease by others
// of them become creases (Canny, A computational approach to edge detection, PAMI 1986).
void continue_creases(const mesh::Mesh& mesh, const std::vector<char>& is_weak,
                      std::vector<std::optional<EdgeKind>>& kinds) {
  DisjointSets connected(mesh.points.size());
  const auto is_crease = [&](std::size_t e) { return kinds[e] == EdgeKind::crease; };
  for (std::size_t e = 0; e < kinds.size(); ++e)
    if (is_weak[e] != 0 || is_crease(e)) connected.join(mesh.edges[e].vertex[0], mesh.edges[e].vertex[1]);
  const std::vector<int> root = std::move(connected).roots();
  std::vector<char> has_crease(root.size(), 0);
  for (std::size_t e = 0; e < kinds.size(); ++e)
    if (is_crease(e)) has_crease[root[mesh.edges[e].vertex[0]]] = 1;
  for (std::size_t e = 0; e < kinds.size(); ++e)
    if (is_weak[e] != 0 && has_crease[root[mesh.edges[e].vertex[0]]] != 0) kinds[e] = EdgeKind::crease;
}

}  // namespace

std::vector<std::optional<EdgeKind>> feature_edges(const world::World& world, const view::ProjectedScene& view,
                                                   int model, const EdgeOptions& options, const Progress& progress) {
  const std::vector<signed char> facing = refine::facing_by_surface(world.models[model], view.projection);
  const EdgeSurroundings around{world, model, view.map.normalisation, world.models[model].mesh->uncut.get(), facing};
  return feature_edges(view, options, around, Slivers(around, view, progress), progress);
}

std::vector<std::optional<EdgeKind>> feature_edges(const view::ProjectedScene& view, const EdgeOptions& options,
                                                   const EdgeSurroundings& around, const Slivers& slivers,
                                                   const Progress& progress) {
  const double crease_angle = options.crease_angle - angle_rounding;
  const surfaces::PartFaces* part = around.world.models[around.model].part.get();
  const std::vector<char> is_tangent =
      options.tangent && part == nullptr ? tangent_edges(around, crease_angle) : std::vector<char>();
  const std::vector<Vec3> polygon_normals = mean_normals(around);
  const std::vector<char> moved = moved_vertices(around);
  const std::vector<char> seen_edge_on = walls(around, view);
  const EdgeJudge judge{around,
                        view,
                        options,
                        slivers,
                        is_tangent,
                        polygon_normals,
                        FoldLimit(crease_angle),
                        part,
                        seen_edge_on,
                        view::page_resolution(around.world, view) / view.cell,
                        view::grid_resolution(view) / view.cell,
                        moved,
                        flat_within(around)};
  const auto& edges = around.world.models[around.model].mesh->edges;
  check(is_tangent.empty() || is_tangent.size() == around.mesh().edges.size(), "every edge is tangent or not");
  const bool has_weak = part == nullptr && options.crease && options.weak_angle < options.crease_angle;
  EdgeJudge weak = judge;
  if (has_weak) weak.crease = FoldLimit(options.weak_angle - angle_rounding);
  std::vector<std::optional<EdgeKind>> kinds(edges.size());
  std::vector<char> is_weak(has_weak ? edges.size() : 0, 0);
  parallel_for(edges.size(), grain::light, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      // What is no crease with the weak angle, is the same with the other.
      kinds[e] = weak.kind_of(edges[e]);
      if (!has_weak || kinds[e] != EdgeKind::crease) continue;
      kinds[e] = judge.kind_of(edges[e]);
      is_weak[e] = kinds[e] ? 0 : 1;
    }
    progress.advance(end - begin);
  });
  if (has_weak) continue_creases(*around.world.models[around.model].mesh, is_weak, kinds);
  return kinds;
}

}  // namespace epura::edges
