// SPDX-License-Identifier: Apache-2.0
#include "refine/refine_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "mesh/edge_table.hpp"
#include "refine/contour_plane.hpp"
#include "refine/limits.hpp"
#include "refine/split_triangle.hpp"
#include "world/placed_part.hpp"

namespace epura::refine {

namespace {

using surfaces::PartFaces;

/// A new vertex on an edge of the mesh, where the contour of a face crosses it.
struct Split {
  int edge;
  double t;
  int face;
  int vertex = -1;
};

/// Where the contours of faces cross the mesh.
struct Crossings {
  std::vector<Split> splits;                     ///< inside edges; by edge and place
  std::vector<std::pair<int, int>> at_vertices;  ///< face and vertex; ascending
};

/// The heights of a face's vertices over its contour plane.
class Heights {
 public:
  explicit Heights(std::size_t vertices) : heights_(vertices, 0), faces_(vertices, -1) {}

  void set(int face, int vertex, double height) {
    heights_[static_cast<std::size_t>(vertex)] = height;
    faces_[static_cast<std::size_t>(vertex)] = face;
  }
  [[nodiscard]] bool has(int face, int vertex) const { return faces_[static_cast<std::size_t>(vertex)] == face; }
  [[nodiscard]] double of(int vertex) const { return heights_[static_cast<std::size_t>(vertex)]; }

 private:
  std::vector<double> heights_;
  std::vector<int> faces_;  ///< to which the heights belong
};

/// What the contours of one model are found from.
struct Model {
  const mesh::Mesh& mesh;
  const PartFaces& part;
  std::vector<int> faces;                           ///< by triangle; -1: of a cut
  std::vector<std::optional<ContourPlane>> planes;  ///< by face

  [[nodiscard]] int face_of(int triangle) const { return faces[static_cast<std::size_t>(triangle)]; }
  [[nodiscard]] const ContourPlane* plane_at(int triangle) const {
    if (face_of(triangle) < 0) return nullptr;
    const auto& plane = planes[static_cast<std::size_t>(face_of(triangle))];
    return plane ? &*plane : nullptr;
  }
};

double parameter_of_zero(double from, double to) { return from / (from - to); }

// Whether the viewer sees a vertex beyond the contour that passes close to it, since it is not quite on the surface:
// facets between both would turn the wrong way. `place` is where the contour crosses an edge at the vertex.
bool is_seen_beyond(const surfaces::PartSurface& surface, const Vec3& vertex, const Vec3& place) {
  const double off = std::max(surfaces::signed_distance(surface, vertex), 0.0);
  const double beyond = glm::dot(vertex - place, surfaces::normal_near(surface, place));
  return beyond + surfaces::signed_distance(surface, place) + off >= 0;
}

// Sets the heights of a face; 0 for vertices through which its contour passes.
void find_heights(const Model& model, int face, std::span<const int> triangles, Heights& heights) {
  const ContourPlane& plane = *model.planes[static_cast<std::size_t>(face)];
  const surfaces::PartSurface& surface = model.part.faces[static_cast<std::size_t>(face)].surface;
  for (const int t : triangles)
    for (const int v : model.mesh.triangle(t))
      if (!heights.has(face, v)) heights.set(face, v, plane.height(model.mesh.point(v)));
  for (const int t : triangles) {
    const std::array<int, 3> corners = model.mesh.triangle(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = corners[i], b = corners[(i + 1) % 3];
      const double from = heights.of(a), to = heights.of(b);
      if (!(from * to < 0)) continue;
      const double at = parameter_of_zero(from, to);
      const int near = at < 0.5 ? a : b;
      const Vec3 p = model.mesh.point(a), place = p + at * (model.mesh.point(b) - p);
      if (std::min(at, 1 - at) < at_corner || is_seen_beyond(surface, model.mesh.point(near), place))
        heights.set(face, near, 0);
    }
  }
}

void add_crossings(const Model& model, int face, std::span<const int> triangles, const Heights& heights,
                   Crossings& crossings) {
  for (const int t : triangles) {
    const std::array<int, 3> corners = model.mesh.triangle(t);
    for (std::size_t i = 0; i < 3; ++i) {
      if (heights.of(corners[i]) == 0) crossings.at_vertices.emplace_back(face, corners[i]);
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      if (!(heights.of(low) * heights.of(high) < 0)) continue;
      const mesh::MeshEdge* edge = model.mesh.edge_between({low, high});
      check(edge != nullptr, "the sides of triangles are edges");
      crossings.splits.push_back({static_cast<int>(edge - model.mesh.edges.data()),
                                  parameter_of_zero(heights.of(low), heights.of(high)), face});
    }
  }
}

Crossings find_crossings(const Model& model) {
  const std::vector<int>& face_of = model.faces;
  const Groups<int> by_face(model.planes.size(), [&](const auto& visit) {
    for (std::size_t t = 0; t < face_of.size(); ++t)
      if (model.plane_at(static_cast<int>(t)) != nullptr)
        visit(static_cast<std::size_t>(face_of[t]), static_cast<int>(t));
  });
  Crossings crossings;
  Heights heights(model.mesh.points.size());
  for (std::size_t f = 0; f < model.planes.size(); ++f) {
    if (!model.planes[f]) continue;
    const int face = static_cast<int>(f);
    find_heights(model, face, by_face[f], heights);
    add_crossings(model, face, by_face[f], heights, crossings);
  }
  const auto drop_repeated = [](auto& items, const auto& key) {
    const auto is_same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
    items.erase(std::unique(items.begin(), items.end(), is_same), items.end());
  };
  // Both triangles at an edge find its splits.
  std::ranges::sort(crossings.splits, {}, [](const Split& s) { return std::tuple(s.edge, s.t, s.face); });
  drop_repeated(crossings.splits, [](const Split& s) { return std::tuple(s.edge, s.t, s.face); });
  std::ranges::sort(crossings.at_vertices);
  drop_repeated(crossings.at_vertices, std::identity());
  return crossings;
}

// The surface beyond the side of a face; nothing if none is known. Beyond a cut, it is the plane of its triangle.
std::optional<surfaces::PartSurface> surface_beyond(const Model& model, const mesh::MeshEdge& edge, int face) {
  const std::span<const int> beside = model.mesh.triangles_of(edge);
  if (beside.size() != 2) return std::nullopt;
  for (const int t : beside) {
    const int other = model.face_of(t);
    if (other == face) continue;
    if (other >= 0) return model.part.faces[static_cast<std::size_t>(other)].surface;
    const auto [a, b, c] = model.mesh.triangle(t);
    const Vec3 p = model.mesh.point(a), across = glm::cross(model.mesh.point(b) - p, model.mesh.point(c) - p);
    if (!(glm::length(across) > 0)) return std::nullopt;
    surfaces::PartSurface plane;
    plane.kind = surfaces::SurfaceKind::plane;
    plane.origin = p;
    plane.axis = glm::normalize(across);
    return plane;
  }
  return std::nullopt;
}

// Where the vertex of a split lies.
Vec3 place_of(const Model& model, const Split& split) {
  const mesh::MeshEdge& edge = model.mesh.edges[static_cast<std::size_t>(split.edge)];
  const auto face = static_cast<std::size_t>(split.face);
  const Vec3 a = model.mesh.point(edge.vertex[0]), b = model.mesh.point(edge.vertex[1]);
  const Vec3 place = a + split.t * (b - a);
  const std::span<const int> beside = model.mesh.triangles_of(edge);
  const bool is_inside =
      beside.size() == 2 && std::ranges::all_of(beside, [&](int t) { return model.face_of(t) == split.face; });
  std::optional<surfaces::PartSurface> beyond;
  if (!is_inside) beyond = surface_beyond(model, edge, split.face);
  std::optional<Rim> rim;
  if (!is_inside) rim = Rim{glm::normalize(b - a), beyond ? &*beyond : nullptr};
  return place_on_contour(model.part.faces[face].surface, *model.planes[face], place, rim, glm::distance(a, b) / 2);
}

// Adds a vertex for each split; one for contours of two faces that cross their border in one place.
void add_vertices(const Model& model, std::vector<Split>& splits, mesh::Mesh& refined) {
  for (std::size_t i = 0; i < splits.size(); ++i) {
    Split& split = splits[i];
    if (i > 0 && splits[i - 1].edge == split.edge && split.t - splits[i - 1].t < at_corner) {
      split.vertex = splits[i - 1].vertex;
      continue;
    }
    split.vertex = static_cast<int>(refined.points.size());
    const Vec3 place = place_of(model, split);
    refined.points.push_back({place.x, place.y, place.z});
    const mesh::EdgeOrigin origin = model.mesh.origin_of(model.mesh.edges[static_cast<std::size_t>(split.edge)]);
    refined.cut_vertices.push_back(
        origin.in_file ? mesh::CutVertex{origin.vertex, origin.t[0] + split.t * (origin.t[1] - origin.t[0])}
                       : mesh::CutVertex{{-1, -1}, 0});
  }
}

std::span<const Split> splits_at(const std::vector<Split>& splits, std::ptrdiff_t edge) {
  const auto [first, last] = std::equal_range(splits.begin(), splits.end(), Split{static_cast<int>(edge), 0, 0},
                                              [](const Split& a, const Split& b) { return a.edge < b.edge; });
  return {first, last};
}

/// A triangle to be split.
struct Facet {
  const Model& model;
  const Crossings& crossings;
  const mesh::Mesh& refined;  ///< has all vertices
  std::array<int, 3> corners;
  int face;
  const ContourPlane* plane;  ///< of the face; null if it has none

  [[nodiscard]] int side_of(const Vec3& place) const { return plane == nullptr || plane->height(place) > 0 ? 1 : -1; }
  [[nodiscard]] int side_of_corner(std::size_t i) const {
    const bool is_on =
        plane != nullptr && std::ranges::binary_search(crossings.at_vertices, std::pair(face, corners[i]));
    return is_on ? 0 : side_of(model.mesh.point(corners[i]));
  }
};

// Adds the splits at a side of a triangle.
void add_side(const Facet& facet, std::size_t i, std::vector<RingPoint>& ring) {
  constexpr std::array<Vec2, 3> in_triangle{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  const mesh::Mesh& mesh = facet.model.mesh;
  const int from = facet.corners[i], to = facet.corners[(i + 1) % 3];
  const Vec2 flat = in_triangle[i], along = in_triangle[(i + 1) % 3] - flat;
  ring.push_back({from, flat, mesh.point(from), facet.side_of_corner(i)});
  const mesh::MeshEdge* edge = mesh.edge_between({std::min(from, to), std::max(from, to)});
  check(edge != nullptr, "the sides of triangles are edges");
  const std::span<const Split> here = splits_at(facet.crossings.splits, edge - mesh.edges.data());
  for (std::size_t k = 0; k < here.size(); ++k) {
    const Split& split = here[from < to ? k : here.size() - 1 - k];
    const bool is_own = facet.plane != nullptr && split.face == facet.face;
    if (ring.back().vertex != split.vertex) {
      const double t = from < to ? split.t : 1 - split.t;
      const Vec3 on_side = mesh.point(from) + t * (mesh.point(to) - mesh.point(from));
      ring.push_back({split.vertex, flat + t * along, facet.refined.point(split.vertex), facet.side_of(on_side)});
    }
    if (is_own) ring.back().side = 0;
  }
}

// Returns the triangle of the original mesh of which each one is a part.
std::vector<int> split_triangles(const Model& model, const Crossings& crossings, mesh::Mesh& refined, PartFaces& part) {
  std::vector<int> wholes;
  std::vector<char> is_split(model.faces.size(), 0);
  for (const Split& split : crossings.splits)
    for (const int t : model.mesh.triangles_of(model.mesh.edges[static_cast<std::size_t>(split.edge)]))
      is_split[static_cast<std::size_t>(t)] = 1;
  const auto add = [&](const std::array<int, 3>& corners, std::size_t t) {
    refined.corners.insert(refined.corners.end(), corners.begin(), corners.end());
    refined.polygon.push_back(model.mesh.polygon[t]);
    refined.body.push_back(model.mesh.body[t]);
    part.face_of_triangle.push_back(model.faces[t]);
    wholes.push_back(static_cast<int>(t));
  };
  for (std::size_t t = 0; t < is_split.size(); ++t) {
    const int triangle = static_cast<int>(t);
    if (is_split[t] == 0) {
      add(model.mesh.triangle(triangle), t);
      continue;
    }
    const Facet facet{
        model, crossings, refined, model.mesh.triangle(triangle), model.faces[t], model.plane_at(triangle)};
    std::vector<RingPoint> ring;
    for (std::size_t i = 0; i < 3; ++i) add_side(facet, i, ring);
    for (const std::array<int, 3>& corners : split_triangle(ring)) add(corners, t);
  }
  return wholes;
}

/// The triangles of a refined model that lie in planes. A new vertex at a hollow rim may be beyond thin ones, which are
/// folded over then.
class FlatTriangles {
 public:
  FlatTriangles(const Model& model, const std::vector<int>& wholes, mesh::Mesh& refined)
      : model_(model), wholes_(wholes), refined_(refined) {}

  /// Flips sides beyond new vertices until the triangles cover their planes once.
  void unfold() {
    std::vector<int> open;
    for (int t = 0; t < refined_.triangle_count(); ++t)
      if (is_new(t) && is_folded(t)) open.push_back(t);
    if (open.empty()) return;
    find_sides(open);
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      if (!is_folded(t)) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (const int other = flip(t, i); other >= 0) {
          open.insert(open.end(), {t, other});
          break;
        }
    }
  }

 private:
  static constexpr int none = -1;

  // Of the plane of the part or of the cut in which a triangle lies.
  [[nodiscard]] int plane_of(int triangle) const {
    const int whole = wholes_[static_cast<std::size_t>(triangle)], face = model_.face_of(whole);
    if (face < 0 && model_.mesh.uncut == nullptr) return none;
    if (face < 0) return static_cast<int>(model_.planes.size()) + model_.mesh.polygon[static_cast<std::size_t>(whole)];
    const bool is_plane =
        model_.part.faces[static_cast<std::size_t>(face)].surface.kind == surfaces::SurfaceKind::plane;
    return is_plane ? face : none;
  }

  [[nodiscard]] bool is_new(int triangle) const {
    return std::ranges::any_of(refined_.triangle(triangle), [&](int v) { return is_new_vertex(v); });
  }
  [[nodiscard]] bool is_new_vertex(int v) const { return v >= static_cast<int>(model_.mesh.points.size()); }

  [[nodiscard]] static Vec3 across(const mesh::Mesh& mesh, const std::array<int, 3>& corners) {
    const Vec3 a = mesh.point(corners[0]);
    return glm::cross(mesh.point(corners[1]) - a, mesh.point(corners[2]) - a);
  }
  // Which way a triangle turned before it was split.
  [[nodiscard]] Vec3 turn(int triangle) const {
    const Vec3 whole = across(model_.mesh, model_.mesh.triangle(wholes_[static_cast<std::size_t>(triangle)]));
    return glm::length(whole) > 0 ? glm::normalize(whole) : whole;
  }
  [[nodiscard]] bool is_folded(int triangle) const {
    return plane_of(triangle) != none && glm::dot(across(refined_, refined_.triangle(triangle)), turn(triangle)) < 0;
  }

  static std::array<int, 2> side(const std::array<int, 3>& corners, std::size_t i) {
    const auto [low, high] = std::minmax(corners[(i + 1) % 3], corners[(i + 2) % 3]);
    return {low, high};
  }
  // Puts a triangle in the place of another one beside its sides.
  void set_sides(int triangle, int before, int after) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<int>& beside = beside_[side(refined_.triangle(triangle), i)];
      std::erase(beside, before);
      if (after >= 0) beside.push_back(after);
    }
  }
  void set_corners(int triangle, const std::array<int, 3>& corners) {
    std::ranges::copy(corners, refined_.corners.begin() + 3 * std::ptrdiff_t{triangle});
  }

  // Finds what lies beside the sides of planes in which triangles are folded over.
  void find_sides(const std::vector<int>& folded) {
    std::set<int> planes;
    for (const int t : folded) planes.insert(plane_of(t));
    std::vector<int> others;
    for (int t = 0; t < refined_.triangle_count(); ++t) {
      if (planes.contains(plane_of(t)))
        set_sides(t, -1, t);
      else if (plane_of(t) != none)
        others.push_back(t);
    }
    for (const int t : others)
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto at = beside_.find(side(refined_.triangle(t), i)); at != beside_.end()) at->second.push_back(t);
  }

  // Flips the side opposite to a corner if that is new and the triangles at the side overlap less then. Returns the
  // other triangle; -1 if the side stays.
  int flip(int triangle, std::size_t corner) {
    const std::array<int, 3> own = refined_.triangle(triangle);
    const int tip = own[corner], from = own[(corner + 1) % 3], to = own[(corner + 2) % 3];
    const std::array<int, 2> ends = side(own, corner);
    const std::vector<int> beside = beside_[ends];
    const mesh::MeshEdge* edge = model_.mesh.edge_between(ends);
    if (!is_new_vertex(tip) || beside.size() != 2 || (edge != nullptr && edge->wire)) return -1;
    const int other = beside[beside[0] == triangle ? 1 : 0];
    if (plane_of(other) != plane_of(triangle) || !(glm::dot(turn(other), turn(triangle)) > 0)) return -1;
    int beyond = -1;
    for (const int v : refined_.triangle(other))
      if (v != from && v != to) beyond = v;
    const auto area = [&](const std::array<int, 3>& c) { return glm::length(across(refined_, c)); };
    const std::array<int, 3> one{tip, from, beyond}, two{tip, beyond, to};
    const double before = area(own) + area(refined_.triangle(other)), after = area(one) + area(two);
    if (beyond == tip || !(after < (1 - rounding_part) * before)) return -1;
    for (const int t : {triangle, other}) set_sides(t, t, -1);
    set_corners(triangle, one);
    set_corners(other, two);
    for (const int t : {triangle, other}) set_sides(t, -1, t);
    return other;
  }

  const Model& model_;
  const std::vector<int>& wholes_;
  mesh::Mesh& refined_;
  std::map<std::array<int, 2>, std::vector<int>> beside_;  ///< by side: the triangles of planes there
};

/// A part of an edge of the original mesh.
struct EdgePart {
  int whole;
  double from;  ///< parameter along it
  int edge;     ///< of the refined mesh
};

// Makes the edges of the refined mesh, with the marks of those of which they are parts. Returns these parts, by whole
// edge and place.
std::vector<EdgePart> make_edges(const Model& model, const std::vector<Split>& splits, mesh::Mesh& refined) {
  std::vector<std::array<int, 2>> wires;
  for (std::size_t e = 0; e < model.mesh.edges.size(); ++e)
    if (model.mesh.edges[e].wire && splits_at(splits, static_cast<std::ptrdiff_t>(e)).empty())
      wires.push_back(model.mesh.edges[e].vertex);
  mesh::make_edges(refined, wires);
  const auto first_new = static_cast<int>(model.mesh.points.size());
  std::vector<Split> at(refined.points.size() - model.mesh.points.size());  // by new vertex
  for (const Split& split : splits) at[static_cast<std::size_t>(split.vertex - first_new)] = split;
  // Where a vertex of the refined mesh lies on an edge of the original.
  const auto place_on = [&](int whole, int vertex) -> std::optional<double> {
    if (vertex >= first_new) {
      const Split& split = at[static_cast<std::size_t>(vertex - first_new)];
      return split.edge == whole ? std::optional(split.t) : std::nullopt;
    }
    const std::array<int, 2>& ends = model.mesh.edges[static_cast<std::size_t>(whole)].vertex;
    return vertex == ends[0] ? std::optional(0.0) : vertex == ends[1] ? std::optional(1.0) : std::nullopt;
  };
  std::vector<EdgePart> parts;
  parts.reserve(refined.edges.size());
  std::size_t next = 0;  // edges of both meshes are sorted by their vertices
  for (std::size_t e = 0; e < refined.edges.size(); ++e) {
    mesh::MeshEdge& edge = refined.edges[e];
    const bool is_old = edge.vertex[1] < first_new;
    while (is_old && model.mesh.edges[next].vertex < edge.vertex) ++next;
    const int whole = is_old ? static_cast<int>(next) : at[static_cast<std::size_t>(edge.vertex[1] - first_new)].edge;
    const std::optional<double> from = place_on(whole, edge.vertex[0]), to = place_on(whole, edge.vertex[1]);
    check(!is_old || (from && to), "a part of an edge belongs to an edge");
    if (from && to) {
      edge.wire = model.mesh.edges[static_cast<std::size_t>(whole)].wire;
      edge.cut = model.mesh.edges[static_cast<std::size_t>(whole)].cut;
      parts.push_back({whole, std::min(*from, *to), static_cast<int>(e)});
    } else if (model.mesh.uncut != nullptr) {
      edge.cut = mesh::CutEdge::inside;
    }
  }
  std::ranges::sort(parts, {}, [](const EdgePart& p) { return std::pair(p.whole, p.from); });
  return parts;
}

// Replaces the edges of borders by their parts, in order along the borders.
void divide_borders(const Model& model, const std::vector<EdgePart>& parts, std::size_t edge_count, PartFaces& part) {
  part.border_of_edge.assign(edge_count, -1);
  for (std::size_t b = 0; b < part.borders.size(); ++b) {
    const std::vector<int> wholes = std::exchange(part.borders[b].edges, {});
    for (std::size_t i = 0; i < wholes.size(); ++i) {
      const auto vertices_of = [&](std::size_t k) {
        return model.mesh.edges[static_cast<std::size_t>(wholes[k])].vertex;
      };
      const std::array<int, 2> own = vertices_of(i);
      const auto has = [&](std::size_t k, int vertex) { return std::ranges::count(vertices_of(k), vertex) > 0; };
      const bool is_last = i + 1 == wholes.size();
      const bool backwards = is_last ? i > 0 && has(i - 1, own[1]) : has(i + 1, own[0]);
      const auto [first, last] =
          std::equal_range(parts.begin(), parts.end(), EdgePart{wholes[i], 0, 0},
                           [](const EdgePart& a, const EdgePart& b) { return a.whole < b.whole; });
      const std::span<const EdgePart> found(first, last);
      std::vector<int>& edges = part.borders[b].edges;
      for (const EdgePart& one : found) {
        edges.push_back(one.edge);
        part.border_of_edge[static_cast<std::size_t>(one.edge)] = static_cast<int>(b);
      }
      if (backwards) std::reverse(edges.end() - std::ssize(found), edges.end());
    }
  }
}

// Returns the number of each triangle in the original mesh; -1 unless it and those beside it are as they were.
std::vector<int> kept_triangles(const mesh::Mesh& mesh, const mesh::Mesh& refined, std::vector<int> wholes) {
  std::vector<char> is_kept(mesh.polygon.size(), 0), is_beside(mesh.polygon.size(), 0);
  for (std::size_t t = 0; t < wholes.size(); ++t) {
    if (refined.triangle(static_cast<int>(t)) == mesh.triangle(wholes[t]))
      is_kept[static_cast<std::size_t>(wholes[t])] = 1;
    else
      wholes[t] = -1;
  }
  for (const mesh::MeshEdge& edge : mesh.edges) {
    const std::span<const int> there = mesh.triangles_of(edge);
    if (std::ranges::all_of(there, [&](int t) { return is_kept[static_cast<std::size_t>(t)] != 0; })) continue;
    for (const int t : there) is_beside[static_cast<std::size_t>(t)] = 1;
  }
  for (int& t : wholes)
    if (t >= 0 && is_beside[static_cast<std::size_t>(t)] != 0) t = -1;
  return wholes;
}

struct RefinedModel {
  world::Placed placed;
  std::vector<int> kept;  ///< RefinedWorld::kept, of this model
};

std::optional<RefinedModel> refine_model(const world::Placed& placed, const projection::Projection& projection) {
  if (placed.part == nullptr || placed.part->faces.empty()) return std::nullopt;
  const mesh::Mesh& mesh = *placed.mesh;
  Model model{mesh, *placed.part, world::faces_of_triangles(placed), {}};
  const Viewer viewer = viewer_of(placed, projection);
  for (const surfaces::PartFace& face : placed.part->faces) model.planes.push_back(contour_plane(face.surface, viewer));
  Crossings crossings = find_crossings(model);
  if (crossings.splits.empty()) return std::nullopt;
  auto refined = std::make_shared<mesh::Mesh>();
  refined->points = mesh.points;
  refined->report = mesh.report;
  refined->uncut = mesh.uncut;
  refined->cut_vertices = mesh.cut_vertices;
  refined->first_cut_vertex = mesh.uncut != nullptr ? mesh.first_cut_vertex : static_cast<int>(mesh.points.size());
  add_vertices(model, crossings.splits, *refined);
  auto part = std::make_shared<PartFaces>(*placed.part);
  part->face_of_triangle.clear();
  std::vector<int> wholes = split_triangles(model, crossings, *refined, *part);
  FlatTriangles(model, wholes, *refined).unfold();
  const std::vector<EdgePart> parts = make_edges(model, crossings.splits, *refined);
  world::Placed result = placed;
  // The faces of a cut model are those of the uncut part.
  if (mesh.uncut == nullptr) {
    divide_borders(model, parts, refined->edges.size(), *part);
    result.part = std::move(part);
  }
  std::vector<int> kept = kept_triangles(mesh, *refined, std::move(wholes));
  result.mesh = std::move(refined);
  return RefinedModel{std::move(result), std::move(kept)};
}

// Adds a model of which a world has the vertices up to those that refinement made; nothing is split if `found` is not
// given.
void append(RefinedWorld& refined, const world::World& world, std::size_t model, std::optional<RefinedModel> found) {
  world::Placed placed = found ? std::move(found->placed) : world.models[model];
  const int first = refined.first_vertex.back();
  const auto begin = world.points.begin() + world.first_vertex[model];
  const auto end = world.points.begin() + world.first_vertex[model + 1];
  refined.points.insert(refined.points.end(), begin, end);
  const mesh::Mesh& mesh = *placed.mesh;
  for (auto v = static_cast<int>(end - begin); v < static_cast<int>(mesh.points.size()); ++v)
    refined.points.push_back(Vec3(placed.to_world * Vec4(mesh.point(v), 1)));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::array<int, 3> corners = mesh.triangle(t);
    for (int& v : corners) v += first;
    refined.triangles.push_back(corners);
    const int kept = found ? found->kept[static_cast<std::size_t>(t)] : t;
    refined.kept.push_back(kept < 0 ? -1 : world.first_triangle[model] + kept);
  }
  refined.first_vertex.push_back(static_cast<int>(refined.points.size()));
  refined.first_triangle.push_back(static_cast<int>(refined.triangles.size()));
  if (!world.wires.empty()) world::append_wires(refined, mesh, first);
  refined.models.push_back(std::move(placed));
}

}  // namespace

std::optional<RefinedWorld> refine_world(const world::World& world, const projection::Projection& projection) {
  std::vector<std::optional<RefinedModel>> found(world.models.size());
  parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t model = begin; model < end; ++model) found[model] = refine_model(world.models[model], projection);
  });
  if (std::ranges::none_of(found, [](const auto& one) { return one.has_value(); })) return std::nullopt;
  RefinedWorld refined{world::without_models(world), {}};
  for (std::size_t model = 0; model < found.size(); ++model) append(refined, world, model, std::move(found[model]));
  return refined;
}

}  // namespace epura::refine
