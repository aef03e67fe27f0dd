// SPDX-License-Identifier: Apache-2.0
#include "edges/dihedral.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"

namespace epura::edges {

const mesh::MeshEdge* find_edge(const EdgeSurroundings& around, const std::array<int, 2>& side) {
  const int first = around.world.first_vertex[around.model];
  return around.mesh().edge_between({side[0] - first, side[1] - first});
}

int EdgeSurroundings::apex(const std::array<int, 2>& edge, int triangle) const {
  const std::array<int, 3> c = corners(triangle);
  const auto on_edge = [&](int v) { return v == edge[0] || v == edge[1]; };
  if (on_edge(c[0]) && on_edge(c[1])) return c[2];
  if (on_edge(c[1]) && on_edge(c[2])) return c[0];
  if (on_edge(c[2]) && on_edge(c[0])) return c[1];
  const Vec3 a = point(edge[0]);
  const Vec3 along = point(edge[1]) - a;
  int apex = -1;
  double farthest = -1;
  for (const int v : c) {
    if (on_edge(v)) continue;
    const double distance = glm::length(glm::cross(along, point(v) - a));
    if (distance > farthest) {
      farthest = distance;
      apex = v;
    }
  }
  check(apex >= 0, "a triangle has a corner beside each edge");
  return apex;
}

std::array<Vec3, 2> normals_at(const EdgeSurroundings& around, const std::array<int, 2>& edge, int first, int second) {
  return normals_beside(around, edge, {around.apex(edge, first), around.apex(edge, second)});
}

std::array<Vec3, 2> normals_beside(const EdgeSurroundings& around, const std::array<int, 2>& edge,
                                   const std::array<int, 2>& apexes) {
  const Vec3 a = around.point(edge[0]);
  const Vec3 along = around.point(edge[1]) - a;
  return {glm::cross(along, around.point(apexes[0]) - a), glm::cross(around.point(apexes[1]) - a, along)};
}

double fold_angle(const EdgeSurroundings& around, const std::array<int, 2>& edge, int first, int second) {
  return fold_angle(normals_at(around, edge, first, second));
}

double fold_angle(const std::array<Vec3, 2>& normals) {
  const auto& [n1, n2] = normals;
  return portable_atan2(glm::length(glm::cross(n1, n2)), glm::dot(n1, n2)) * degrees;
}

FoldLimit::FoldLimit(double limit) : degrees(limit), squared_cosine(2) {
  const double cosine = portable_cos(limit * degree);
  if (limit < 90) squared_cosine = cosine * cosine;
}

bool folds_by(const std::array<Vec3, 2>& normals, const FoldLimit& limit) {
  const auto& [n1, n2] = normals;
  const double product = glm::dot(n1, n2);
  // Flatter than the limit by more than rounding can explain.
  const double min = 1.0001 * limit.squared_cosine * glm::dot(n1, n1) * glm::dot(n2, n2);
  if (product > 0 && product * product > min) return false;
  return fold_angle(normals) >= limit.degrees;
}

double turn_of_surface(const EdgeSurroundings& around, int triangle, double crease_angle) {
  const std::array<int, 3> corners = around.corners(triangle);
  const mesh::Mesh& mesh = around.mesh();
  double turn = 0;
  for (int i = 0; i < 3; ++i) {
    const std::array<int, 2> side = side_of(corners[i], corners[(i + 1) % 3]);
    const mesh::MeshEdge* edge = find_edge(around, side);
    if (edge == nullptr || edge->count != 2) continue;
    const auto both = mesh.triangles_of(*edge);
    const double fold = fold_angle(around, side, both[0], both[1]);
    check(fold >= 0 && fold <= 180, "a fold has 0 to 180 degrees");
    if (fold < crease_angle) turn = std::max(turn, fold);
  }
  return turn;
}

double height_of(const EdgeSurroundings& around, int triangle) {
  const std::array<int, 3> c = around.corners(triangle);
  const Vec3 ab = around.point(c[1]) - around.point(c[0]);
  const Vec3 ac = around.point(c[2]) - around.point(c[0]);
  const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
  return longest > 0 ? glm::length(glm::cross(ab, ac)) / longest : 0;
}

}  // namespace epura::edges
