// SPDX-License-Identifier: Apache-2.0
#include "mesh/subdivide.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "base/portable_math.hpp"
#include "mesh/edge_table.hpp"

namespace epura::mesh {

namespace {

Vec3 normal_of(const Mesh& mesh, int triangle) {
  const auto [a, b, c] = mesh.triangle(triangle);
  return glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a));
}

int third_corner(const Mesh& mesh, int triangle, const MeshEdge& edge) {
  for (const int corner : mesh.triangle(triangle))
    if (corner != edge.vertex[0] && corner != edge.vertex[1]) return corner;
  return edge.vertex[0];
}

bool is_sharp(const Mesh& mesh, const MeshEdge& edge, double sharp) {
  if (edge.count != 2) return true;
  const auto triangles = mesh.triangles_of(edge);
  if (mesh.body[triangles[0]] != mesh.body[triangles[1]]) return true;
  const Vec3 a = normal_of(mesh, triangles[0]), b = normal_of(mesh, triangles[1]);
  const double angle = portable_atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
  return angle >= sharp;
}

/// What surrounds a vertex.
struct Ring {
  int neighbours = 0, sharp = 0;
  Vec3 sum{0}, sharp_sum{0};  ///< of the other ends of its edges
};

Vec3 moved_vertex(const Vec3& p, const Ring& ring) {
  if (ring.neighbours == 0 || ring.sharp > 2) return p;
  if (ring.sharp == 2) return 0.75 * p + 0.125 * ring.sharp_sum;
  const double n = ring.neighbours, cosine = portable_cos(2 * std::numbers::pi / n);
  const double root = 0.375 + 0.25 * cosine, share = (0.625 - root * root) / n;
  return (1 - n * share) * p + share * ring.sum;
}

class Step {
 public:
  /// `creases` by edge.
  Step(const Mesh& mesh, const std::vector<char>& creases) : mesh_(mesh), creases_(creases) {}

  Mesh divide(std::vector<char>& creases) {
    Mesh made;
    made.points = mesh_.points;
    move_vertices(made.points);
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) made.points.push_back(point_on(e));
    for (int t = 0; t < mesh_.triangle_count(); ++t) add_triangles(t, made);
    finish(made);
    creases.assign(made.edges.size(), 0);
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e)
      for (const int end : mesh_.edges[e].vertex)
        if (const MeshEdge* half = creases_[e] != 0 ? made.edge_between({end, middle_of(e)}) : nullptr)
          creases[static_cast<std::size_t>(half - made.edges.data())] = 1;
    return made;
  }

 private:
  [[nodiscard]] int middle_of(std::size_t edge) const { return static_cast<int>(mesh_.points.size() + edge); }
  [[nodiscard]] int middle_between(int a, int b) const {
    const MeshEdge* edge = mesh_.edge_between({std::min(a, b), std::max(a, b)});
    return middle_of(static_cast<std::size_t>(edge - mesh_.edges.data()));
  }

  void move_vertices(Points& points) const {
    std::vector<Ring> rings(mesh_.points.size());
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      if (mesh_.edges[e].count == 0) continue;
      for (const int side : {0, 1}) {
        Ring& ring = rings[static_cast<std::size_t>(mesh_.edges[e].vertex[side])];
        const Vec3 other = mesh_.point(mesh_.edges[e].vertex[1 - side]);
        ++ring.neighbours;
        ring.sum += other;
        if (creases_[e] == 0) continue;
        ++ring.sharp;
        ring.sharp_sum += other;
      }
    }
    for (std::size_t v = 0; v < rings.size(); ++v) {
      const Vec3 p = moved_vertex(mesh_.point(static_cast<int>(v)), rings[v]);
      points[v] = {p.x, p.y, p.z};
    }
  }

  [[nodiscard]] std::array<double, 3> point_on(std::size_t e) const {
    const MeshEdge& edge = mesh_.edges[e];
    Vec3 p = 0.5 * (mesh_.point(edge.vertex[0]) + mesh_.point(edge.vertex[1]));
    if (creases_[e] == 0 && edge.count == 2) {
      const auto triangles = mesh_.triangles_of(edge);
      p = 0.75 * p + 0.125 * (mesh_.point(third_corner(mesh_, triangles[0], edge)) +
                              mesh_.point(third_corner(mesh_, triangles[1], edge)));
    }
    return {p.x, p.y, p.z};
  }

  void add_triangles(int triangle, Mesh& made) const {
    const auto [a, b, c] = mesh_.triangle(triangle);
    const int ab = middle_between(a, b), bc = middle_between(b, c), ca = middle_between(c, a);
    for (const std::array<int, 3>& corners :
         {std::array{a, ab, ca}, std::array{b, bc, ab}, std::array{c, ca, bc}, std::array{ab, bc, ca}}) {
      made.corners.insert(made.corners.end(), corners.begin(), corners.end());
      made.polygon.push_back(static_cast<int>(made.polygon.size()));
      made.body.push_back(mesh_.body[static_cast<std::size_t>(triangle)]);
    }
  }

  void finish(Mesh& made) const {
    std::vector<std::array<int, 2>> wires;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e)
      if (const MeshEdge& edge = mesh_.edges[e]; edge.wire)
        for (const int end : edge.vertex) wires.push_back({end, middle_of(e)});
    make_edges(made, wires);
  }

  const Mesh& mesh_;
  const std::vector<char>& creases_;
};

}  // namespace

Mesh subdivide(Mesh mesh, int steps, double sharp, const Progress& progress) {
  std::vector<char> creases;
  for (const MeshEdge& edge : mesh.edges) creases.push_back(is_sharp(mesh, edge, sharp) ? 1 : 0);
  for (int step = 0; step < steps; ++step) {
    progress.expect_time();
    std::vector<char> next;
    Mesh made = Step(mesh, creases).divide(next);
    made.report = std::move(mesh.report);
    mesh = std::move(made);
    creases = std::move(next);
  }
  mesh.report.triangles = mesh.triangle_count();
  mesh.report.wires = 0;
  mesh.report.open_edges = 0;
  for (const MeshEdge& edge : mesh.edges) {
    if (edge.wire && edge.count == 0) ++mesh.report.wires;
    if (edge.count == 1) ++mesh.report.open_edges;
  }
  mesh.report.resolution = 0;
  return mesh;
}

}  // namespace epura::mesh
