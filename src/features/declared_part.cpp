// SPDX-License-Identifier: Apache-2.0
#include "features/declared_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>

#include "base/portable_math.hpp"
#include "features/region.hpp"
#include "mesh/weld.hpp"

namespace epura::features {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double most_of_it = 0.9;  // of the length of a border

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
    return std::move(part_);
  }

 private:
  struct Triangle {
    std::array<Vec3, 3> corners;
    Vec3 twice_area;  ///< along its normal
    [[nodiscard]] Vec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
    [[nodiscard]] double area() const { return 0.5 * glm::length(twice_area); }
  };

  [[nodiscard]] Triangle triangle(int number) const {
    const auto [a, b, c] = mesh_.triangle(number);
    const std::array corners{mesh_.point(a), mesh_.point(b), mesh_.point(c)};
    return {corners, glm::cross(corners[1] - corners[0], corners[2] - corners[0])};
  }

  // In the order of the file, without those that have no triangles.
  void number_faces() {
    std::vector<int> number(declared_.faces.size(), -1);
    for (const int polygon : mesh_.polygon) number[declared_.face_of_polygon[polygon]] = 0;
    for (std::size_t f = 0; f < number.size(); ++f) {
      if (number[f] < 0) continue;
      number[f] = static_cast<int>(part_.faces.size());
      part_.faces.emplace_back().surface = declared_.faces[f];
    }
    triangles_.resize(part_.faces.size());
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const int face = number[declared_.face_of_polygon[mesh_.polygon[t]]];
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
    if (face.surface.kind != SurfaceKind::sphere) measure_turn(face, points);
  }

  static void measure_turn(PartFace& face, std::span<const Vec3> points) {
    face.from = HUGE_VAL;
    face.to = -HUGE_VAL;
    for (const Vec3& p : points) {
      const double height = glm::dot(p - face.surface.origin, face.surface.axis);
      face.from = std::min(face.from, height);
      face.to = std::max(face.to, height);
    }
    const Places places = places_of(face.surface, points, false, face.residual);
    face.sweep = places.closed ? 360 : places.sweep * degrees;
  }

  void add_declared_borders() {
    // Points at one place have become one vertex.
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

  // Faces at an edge, lower first; -1 where there is only one.
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

  // What is not declared, by the faces that meet there.
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

  // Degrees between the facets on both sides that most of the length does not exceed.
  [[nodiscard]] double angle_along(const std::vector<int>& edges) const {
    std::vector<std::array<double, 2>> angles;  // and lengths
    double length = 0, below = 0;
    for (const int e : edges) {
      const mesh::MeshEdge& edge = mesh_.edges[e];
      const auto triangles = mesh_.triangles_of(edge);
      const Vec3 one = triangle(triangles[0]).twice_area, two = triangle(triangles[1]).twice_area;
      const double angle = portable_atan2(glm::length(glm::cross(one, two)), glm::dot(one, two)) * degrees;
      angles.push_back({angle, glm::distance(mesh_.point(edge.vertex[0]), mesh_.point(edge.vertex[1]))});
      length += angles.back()[1];
    }
    std::sort(angles.begin(), angles.end());
    for (const auto& [angle, part] : angles) {
      below += part;
      if (below >= most_of_it * length) return angle;
    }
    return angles.back()[0];
  }

  const mesh::Mesh& mesh_;
  const DeclaredPart& declared_;
  const double tangent_angle_;
  PartFaces part_;
  std::vector<std::vector<int>> triangles_;  ///< of each face
};

}  // namespace

PartFaces part_of(const mesh::Mesh& mesh, const DeclaredPart& declared, double tangent_angle) {
  return DeclaredFaces(mesh, declared, tangent_angle).make();
}

}  // namespace epura::features
