// SPDX-License-Identifier: Apache-2.0
#include "surfaces/declared_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "mesh/weld.hpp"
#include "surfaces/borders.hpp"
#include "surfaces/limits.hpp"
#include "surfaces/part_surface.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

namespace {

// The mirror image beyond the apex, if the mean point lies there.
PartSurface on_sheet_of_cone(const PartSurface& cone, std::span<const Vec3> points) {
  double radii = 0;
  for (const Vec3& p : points) radii += cone.radius + cone.slope * profile_of(cone, p).y;
  if (radii >= 0) return cone;
  PartSurface other = cone;
  other.origin -= 2 * cone.radius / cone.slope * cone.axis;
  other.axis = -cone.axis;
  return other;
}

bool are_on_inner_sheet(const PartSurface& torus, std::span<const Vec3> points) {
  double outer = 0, inner = 0;
  for (const Vec3& p : points) {
    const Vec2 place = profile_of(torus, p);
    outer += std::abs(std::hypot(place.x - torus.radius, place.y) - torus.minor);
    inner += std::abs(std::hypot(place.x + torus.radius, place.y) - torus.minor);
  }
  return inner < outer;
}

/// Whether a surface is a cone or a torus whose tube is wider than its circle.
bool has_two_sheets(const PartSurface& surface) {
  return (surface.kind == SurfaceKind::cone && surface.slope != 0) ||
         (surface.kind == SurfaceKind::torus && surface.minor > surface.radius);
}

/// Returns the same surface, described so that the points lie on the sheet that it is taken for; a free form if they
/// lie on the inner sheet of a torus.
PartSurface on_sheet_of(const PartSurface& surface, std::span<const Vec3> points) {
  if (!has_two_sheets(surface)) return surface;
  if (surface.kind == SurfaceKind::cone) return on_sheet_of_cone(surface, points);
  return are_on_inner_sheet(surface, points) ? PartSurface{} : surface;
}

class DeclaredFaces {
 public:
  DeclaredFaces(const mesh::Mesh& mesh, const DeclaredPart& declared, double tangent_angle)
      : mesh_(mesh), declared_(declared), tangent_angle_(tangent_angle) {}

  PartFaces make() {
    find_surfaces();
    number_faces();
    describe_faces();
    part_.border_of_edge.assign(mesh_.edges.size(), -1);
    add_declared_borders();
    add_other_borders();
    part_.declared = true;
    return std::move(part_);
  }

 private:
  struct Triangle {
    std::array<Vec3, 3> corners;
    Vec3 twice_area;  ///< vector along the normal with a length of twice the area
    [[nodiscard]] Vec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
    [[nodiscard]] double area() const { return 0.5 * glm::length(twice_area); }
  };

  [[nodiscard]] Triangle triangle(int number) const {
    const auto [a, b, c] = mesh_.triangle(number);
    const std::array corners{mesh_.point(a), mesh_.point(b), mesh_.point(c)};
    return {corners, glm::cross(corners[1] - corners[0], corners[2] - corners[0])};
  }

  [[nodiscard]] int declared_face(int triangle) const { return declared_.face_of_polygon[mesh_.polygon[triangle]]; }

  // The surfaces of the faces of the file, each by the sheet on which the face lies.
  void find_surfaces() {
    std::vector<std::vector<Vec3>> points(declared_.faces.size());
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const int face = declared_face(t);
      if (!has_two_sheets(declared_.faces[face])) continue;
      for (const Vec3& p : triangle(t).corners) points[face].push_back(p);
    }
    for (std::size_t f = 0; f < points.size(); ++f) surfaces_.push_back(on_sheet_of(declared_.faces[f], points[f]));
  }

  // Returns for each face of the file the first of the faces with which it is merged.
  [[nodiscard]] std::vector<int> joined_faces() const {
    DisjointSets faces(surfaces_.size());
    for (const mesh::MeshEdge& edge : mesh_.edges)
      for (const TrianglePair& pair : pairs_by_body(mesh_, edge)) {
        const int one = declared_face(pair[0]), two = declared_face(pair[1]);
        if (one == two || faces.root(one) == faces.root(two) || !are_one(surfaces_[one], surfaces_[two])) continue;
        // A sheet may be folded onto its own surface.
        if (glm::dot(triangle(pair[0]).twice_area, triangle(pair[1]).twice_area) > 0) faces.join(one, two);
      }
    return std::move(faces).roots();
  }

  // Numbers faces in the order of the file, without those that have no triangles.
  void number_faces() {
    const std::vector<int> joined = joined_faces();
    std::vector<int> number(surfaces_.size(), -1);
    for (const int polygon : mesh_.polygon) number[joined[declared_.face_of_polygon[polygon]]] = 0;
    for (std::size_t f = 0; f < number.size(); ++f) {
      if (number[f] < 0) continue;
      number[f] = static_cast<int>(part_.faces.size());
      part_.faces.emplace_back().surface = surfaces_[f];
    }
    triangles_.resize(part_.faces.size());
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const int face = number[joined[declared_face(t)]];
      part_.face_of_triangle.push_back(face);
      triangles_[face].push_back(t);
    }
  }

  void describe_faces() {
    double area = 0, sure = 0;
    for (std::size_t f = 0; f < part_.faces.size(); ++f) {
      PartFace& face = part_.faces[f];
      describe(face, triangles_[f]);
      area += face.area;
      if (face.surface.kind != SurfaceKind::free_form) sure += face.area;
      part_.tolerance = std::max(part_.tolerance, face.residual);
    }
    part_.recognised = area > 0 ? sure / area : 0;
  }

  void describe(PartFace& face, const std::vector<int>& triangles) const {
    face.triangles = static_cast<int>(triangles.size());
    face.body = mesh_.body[triangles.front()];
    const bool is_free = face.surface.kind == SurfaceKind::free_form;
    std::vector<Vec3> points;
    double outwards = 0;
    for (const int t : triangles) {
      const Triangle at = triangle(t);
      face.area += at.area();
      if (is_free) continue;
      points.insert(points.end(), at.corners.begin(), at.corners.end());
      face.sagitta += std::abs(signed_distance(face.surface, at.middle())) / static_cast<double>(triangles.size());
      outwards += glm::dot(normal_near(face.surface, at.middle()), at.twice_area);
    }
    if (is_free) return;
    face.residual = residual_of(face.surface, points);
    if (face.surface.kind == SurfaceKind::plane) {
      if (outwards < 0) face.surface.axis = -face.surface.axis;
      return;
    }
    face.inwards = outwards < 0;
    if (face.surface.kind == SurfaceKind::sphere) return;
    const Reach reach = reach_of(face.surface, points, face.residual);
    face.from = reach.from;
    face.to = reach.to;
    face.sweep = sweep_around(face.surface, reach, [&](const auto& is_over) {
      return std::any_of(triangles.begin(), triangles.end(), [&](int t) { return is_over(triangle(t).corners); });
    });
  }

  // Returns the edges of the mesh along each declared edge, as far as they are borders.
  [[nodiscard]] std::vector<std::vector<int>> edges_of_declared() const {
    // Points at the same place have become one vertex.
    const std::vector<int> vertex = mesh::same_places(mesh_.points);
    std::vector<std::vector<int>> edges(declared_.edges.size());
    int begin = 0;
    for (std::size_t d = 0; d < edges.size(); ++d) {
      const int end = declared_.edges[d].end;
      for (int i = begin; i + 1 < end; ++i) {
        const int a = vertex[declared_.edge_vertices[i]], b = vertex[declared_.edge_vertices[i + 1]];
        const mesh::MeshEdge* found = mesh_.edge_between({std::min(a, b), std::max(a, b)});
        if (found != nullptr && is_border(*found)) edges[d].push_back(static_cast<int>(found - mesh_.edges.data()));
      }
      begin = end;
    }
    return edges;
  }

  void add_declared_borders() {
    std::vector<std::vector<int>> edges = edges_of_declared();
    // Where bodies touch, each of them may declare an edge; the sharpest one counts.
    std::map<int, std::pair<double, std::size_t>> sharpest;  // by edge of the mesh: angle, declared edge
    for (std::size_t d = 0; d < edges.size(); ++d) {
      if (edges[d].empty()) continue;
      const double angle = angle_of(edges[d], declared_.edges[d]);
      for (const int e : edges[d])
        if (mesh_.edges[e].count > 2)
          if (const auto [at, is_first] = sharpest.try_emplace(e, angle, d); !is_first && at->second.first < angle)
            at->second = {angle, d};
    }
    for (std::size_t d = 0; d < edges.size(); ++d) {
      std::erase_if(edges[d], [&](int e) {
        const auto found = sharpest.find(e);
        return found != sharpest.end() && found->second.second != d;
      });
      if (!edges[d].empty()) add_border(std::move(edges[d]), declared_.edges[d]);
    }
  }

  [[nodiscard]] std::array<int, 2> faces_of(const TrianglePair& pair) const {
    const auto [one, two] = std::minmax(part_.face_of_triangle[pair[0]], part_.face_of_triangle[pair[1]]);
    return {one, two};
  }

  // The pair of the first body of which different faces meet, if possible at more than the angle of tangent ones: then
  // it is the same all along a border, whatever rounding does to the angles.
  [[nodiscard]] TrianglePair first_sharp_of(const std::vector<TrianglePair>& pairs) const {
    if (pairs.size() == 1) return pairs.front();
    const auto rank = [&](const TrianglePair& pair) {
      const auto [one, two] = faces_of(pair);
      return std::pair(one != two, angle_between(pair) > tangent_angle_);
    };
    return *std::max_element(pairs.begin(), pairs.end(),
                             [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  }

  [[nodiscard]] bool is_open(const mesh::MeshEdge& edge) const { return pairs_by_body(mesh_, edge).empty(); }

  // Returns the faces at an edge, lower first; -1 if there is only one.
  [[nodiscard]] std::array<int, 2> faces_at(const mesh::MeshEdge& edge) const {
    if (const auto pairs = pairs_by_body(mesh_, edge); !pairs.empty()) return faces_of(first_sharp_of(pairs));
    const auto triangles = mesh_.triangles_of(edge);
    const int one = part_.face_of_triangle[triangles[0]];
    const int two = triangles.size() > 1 ? part_.face_of_triangle[triangles[1]] : -1;
    return {std::min(one, two), std::max(one, two)};
  }

  [[nodiscard]] bool is_border(const mesh::MeshEdge& edge) const {
    if (edge.count == 0) return false;
    const std::vector<TrianglePair> pairs = pairs_by_body(mesh_, edge);
    return pairs.empty() || std::any_of(pairs.begin(), pairs.end(), [&](const TrianglePair& pair) {
             const auto [one, two] = faces_of(pair);
             return one != two;
           });
  }

  // Adds borders that are not declared, one for each pair of faces that meet there.
  void add_other_borders() {
    std::map<std::tuple<std::array<int, 2>, bool>, std::vector<int>> groups;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const mesh::MeshEdge& edge = mesh_.edges[e];
      if (part_.border_of_edge[e] < 0 && is_border(edge))
        groups[{faces_at(edge), is_open(edge)}].push_back(static_cast<int>(e));
    }
    for (auto& [faces, edges] : groups) add_border(std::move(edges), {std::nan(""), false, 0});
  }

  // The angle of a border in degrees, as declared if it is.
  [[nodiscard]] double angle_of(const std::vector<int>& edges, const DeclaredEdge& declared) const {
    if (is_open(mesh_.edges[edges.front()])) return 180;
    double angle = declared.angle;
    if (std::isnan(angle)) angle = declared.is_tangent ? 0 : angle_along(edges);
    return declared.is_tangent ? std::min(angle, tangent_angle_) : angle;
  }

  void add_border(std::vector<int> edges, const DeclaredEdge& declared) {
    const mesh::MeshEdge& first = mesh_.edges[edges.front()];
    PartBorder border{faces_at(first), BorderKind::sharp, angle_of(edges, declared), {}, false};
    if (is_open(first))
      border.kind = BorderKind::open;
    else if (border.angle <= tangent_angle_)
      border.kind = BorderKind::tangent;
    for (const int edge : edges) part_.border_of_edge[edge] = static_cast<int>(part_.borders.size());
    border.edges = std::move(edges);
    part_.borders.push_back(std::move(border));
  }

  [[nodiscard]] double angle_between(const TrianglePair& pair) const {
    const Vec3 one = triangle(pair[0]).twice_area, two = triangle(pair[1]).twice_area;
    return portable_atan2(glm::length(glm::cross(one, two)), glm::dot(one, two)) * degrees;
  }

  [[nodiscard]] double angle_along(const std::vector<int>& edges) const {
    std::vector<AngleAlong> angles;
    for (const int e : edges) {
      const mesh::MeshEdge& edge = mesh_.edges[e];
      double angle = 0;
      for (const TrianglePair& pair : pairs_by_body(mesh_, edge))
        if (const auto [one, two] = faces_of(pair); one != two) angle = std::max(angle, angle_between(pair));
      angles.push_back({angle, glm::distance(mesh_.point(edge.vertex[0]), mesh_.point(edge.vertex[1]))});
    }
    return angle_of_most(std::move(angles), max_of_border);
  }

  const mesh::Mesh& mesh_;
  const DeclaredPart& declared_;
  const double tangent_angle_;
  PartFaces part_;
  std::vector<PartSurface> surfaces_;        ///< by face of the file
  std::vector<std::vector<int>> triangles_;  ///< by face
};

// Adds a border as declared edges, one for each part of it without a gap.
void declare_again(DeclaredPart& declared, const PartBorder& border, const mesh::Mesh& mesh) {
  const auto ends_of = [&](std::size_t i) { return mesh.edges[static_cast<std::size_t>(border.edges[i])].vertex; };
  const auto has = [&](std::size_t i, int v) {
    return i < border.edges.size() && (ends_of(i)[0] == v || ends_of(i)[1] == v);
  };
  std::vector<int>& vertices = declared.edge_vertices;
  for (std::size_t i = 0; i < border.edges.size(); ++i) {
    const auto [a, b] = ends_of(i);
    const bool continues = i > 0 && has(i, vertices.back());
    if (!continues) {
      vertices.push_back(has(i + 1, a) ? b : a);
      declared.edges.push_back({border.angle, border.kind == BorderKind::tangent ? 1 : 0, 0});
    }
    vertices.push_back(vertices.back() == a ? b : a);
    declared.edges.back().end = static_cast<int>(vertices.size());
  }
}

}  // namespace

PartFaces part_of(const mesh::Mesh& mesh, const DeclaredPart& declared, double tangent_angle) {
  return DeclaredFaces(mesh, declared, tangent_angle).make();
}

PartFaces part_with_face(const PartFaces& part, const mesh::Mesh& before, const ReplacedTriangles& now,
                         double tangent_angle) {
  check(now.face_of_triangle.size() == now.mesh.polygon.size(), "every triangle has a face");
  DeclaredPart declared;
  for (const PartFace& face : part.faces) declared.faces.push_back(face.surface);
  declared.faces.push_back(now.added);
  for (std::size_t t = 0; t < now.face_of_triangle.size(); ++t) {
    const auto polygon = static_cast<std::size_t>(now.mesh.polygon[t]);
    if (polygon >= declared.face_of_polygon.size()) declared.face_of_polygon.resize(polygon + 1, 0);
    declared.face_of_polygon[polygon] = now.face_of_triangle[t];
  }
  for (const PartBorder& border : part.borders)
    if (border.kind != BorderKind::open) declare_again(declared, border, before);
  return part_of(now.mesh, declared, tangent_angle);
}

}  // namespace epura::surfaces
