// SPDX-License-Identifier: Apache-2.0
#include "features/declared_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/borders.hpp"
#include "features/region.hpp"
#include "mesh/weld.hpp"

namespace epura::features {

namespace {

class DeclaredFaces {
 public:
  DeclaredFaces(const mesh::Mesh& mesh, const DeclaredPart& declared, double tangent_angle)
      : mesh_(mesh), declared_(declared), tangent_angle_(tangent_angle) {}

  PartFaces make() {
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

  // Returns for each face of the file the first of the faces with which it is merged.
  [[nodiscard]] std::vector<int> joined_faces() const {
    DisjointSets faces(declared_.faces.size());
    for (const mesh::MeshEdge& edge : mesh_.edges) {
      if (edge.count != 2) continue;
      const auto triangles = mesh_.triangles_of(edge);
      const int one = declared_face(triangles[0]), two = declared_face(triangles[1]);
      if (one == two || faces.root(one) == faces.root(two) || !are_one(declared_.faces[one], declared_.faces[two]))
        continue;
      // A sheet may be folded onto its own surface.
      if (glm::dot(triangle(triangles[0]).twice_area, triangle(triangles[1]).twice_area) > 0) faces.join(one, two);
    }
    return std::move(faces).roots();
  }

  // Numbers faces in the order of the file, without those that have no triangles.
  void number_faces() {
    const std::vector<int> joined = joined_faces();
    std::vector<int> number(declared_.faces.size(), -1);
    for (const int polygon : mesh_.polygon) number[joined[declared_.face_of_polygon[polygon]]] = 0;
    for (std::size_t f = 0; f < number.size(); ++f) {
      if (number[f] < 0) continue;
      number[f] = static_cast<int>(part_.faces.size());
      part_.faces.emplace_back().surface = declared_.faces[f];
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
    face.sweep = reach.sweep;
  }

  void add_declared_borders() {
    // Points at the same place have become one vertex.
    const std::vector<int> vertex = mesh::same_places(mesh_.points);
    int begin = 0;
    for (const DeclaredEdge& edge : declared_.edges) {
      std::vector<int> edges;
      for (int i = begin; i + 1 < edge.end; ++i) {
        const int a = vertex[declared_.edge_vertices[i]], b = vertex[declared_.edge_vertices[i + 1]];
        const mesh::MeshEdge* found = mesh_.edge_between({std::min(a, b), std::max(a, b)});
        if (found != nullptr && is_border(*found)) edges.push_back(static_cast<int>(found - mesh_.edges.data()));
      }
      begin = edge.end;
      if (!edges.empty()) add_border(std::move(edges), edge);
    }
  }

  // Returns the faces at an edge, lower first; -1 if there is only one.
  [[nodiscard]] std::array<int, 2> faces_at(const mesh::MeshEdge& edge) const {
    const auto triangles = mesh_.triangles_of(edge);
    const int one = part_.face_of_triangle[triangles[0]];
    const int two = triangles.size() > 1 ? part_.face_of_triangle[triangles[1]] : -1;
    return {std::min(one, two), std::max(one, two)};
  }

  [[nodiscard]] bool is_border(const mesh::MeshEdge& edge) const {
    if (edge.count == 0) return false;
    const auto [one, two] = faces_at(edge);
    return edge.count != 2 || one != two;
  }

  // Adds borders that are not declared, one for each pair of faces that meet there.
  void add_other_borders() {
    std::map<std::tuple<std::array<int, 2>, bool>, std::vector<int>> groups;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const mesh::MeshEdge& edge = mesh_.edges[e];
      if (part_.border_of_edge[e] < 0 && is_border(edge))
        groups[{faces_at(edge), edge.count != 2}].push_back(static_cast<int>(e));
    }
    for (auto& [faces, edges] : groups) add_border(std::move(edges), {std::nan(""), false, 0});
  }

  void add_border(std::vector<int> edges, const DeclaredEdge& declared) {
    const mesh::MeshEdge& first = mesh_.edges[edges.front()];
    PartBorder border{faces_at(first), BorderKind::sharp, declared.angle, {}, false};
    if (first.count != 2) {
      border.kind = BorderKind::open;
      border.angle = 180;
    } else {
      if (std::isnan(border.angle)) border.angle = declared.is_tangent ? 0 : angle_along(edges);
      if (declared.is_tangent) border.angle = std::min(border.angle, tangent_angle_);
      if (border.angle <= tangent_angle_) border.kind = BorderKind::tangent;
    }
    for (const int edge : edges) part_.border_of_edge[edge] = static_cast<int>(part_.borders.size());
    border.edges = std::move(edges);
    part_.borders.push_back(std::move(border));
  }

  [[nodiscard]] double angle_along(const std::vector<int>& edges) const {
    std::vector<AngleAlong> angles;
    for (const int e : edges) {
      const mesh::MeshEdge& edge = mesh_.edges[e];
      const auto triangles = mesh_.triangles_of(edge);
      const Vec3 one = triangle(triangles[0]).twice_area, two = triangle(triangles[1]).twice_area;
      const double angle = portable_atan2(glm::length(glm::cross(one, two)), glm::dot(one, two)) * degrees;
      angles.push_back({angle, glm::distance(mesh_.point(edge.vertex[0]), mesh_.point(edge.vertex[1]))});
    }
    return angle_of_most(std::move(angles));
  }

  const mesh::Mesh& mesh_;
  const DeclaredPart& declared_;
  const double tangent_angle_;
  PartFaces part_;
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

}  // namespace epura::features
