// SPDX-License-Identifier: Apache-2.0
// The angle of the fold between two triangles at their common edge, for any orientation.
#pragma once

#include <array>

#include "scene/scene.hpp"

namespace epura::edges {

/// One model of a world, with what edge decisions need of it.
struct EdgeSurroundings {
  const scene::World& world;
  int model;
  double normalisation;  ///< power of two that brings lengths near 1, so that products of them stay in range
  /// The mesh before a plane cut it, to be judged in its place: edges and triangles below are of that then.
  const mesh::Mesh* uncut = nullptr;

  [[nodiscard]] const mesh::Mesh& mesh() const { return uncut != nullptr ? *uncut : *world.models[model].mesh; }
  /// The corners of a triangle, as vertices of the world.
  [[nodiscard]] std::array<int, 3> corners(int triangle) const {
    if (uncut == nullptr) return world.triangles[world.first_triangle[model] + triangle];
    std::array<int, 3> corners = uncut->triangle(triangle);
    for (int& v : corners) v += world.first_vertex[model];
    return corners;
  }
  [[nodiscard]] Vec3 point(int vertex) const { return world.points[vertex] * normalisation; }
  /// The corner of a triangle that is not on the edge. Behind a sliver a triangle may share less than the whole edge
  /// with the one before it, so it is the corner farthest from the edge's line.
  [[nodiscard]] int apex(const std::array<int, 2>& edge, int triangle) const;
};

/// The edge between two vertices of the world, the lower number first; null when the model has none there.
const mesh::MeshEdge* find_edge(const EdgeSurroundings& around, const std::array<int, 2>& side);

/// Normals of two triangles at their common edge, of any length, equal in direction where one continues the other
/// flatly.
std::array<Vec3, 2> normals_at(const EdgeSurroundings& around, const std::array<int, 2>& edge, int first, int second);

/// Degrees by which the second triangle turns away from continuing the first one flatly: 0 flat, 180 folded back.
double fold_angle(const EdgeSurroundings& around, const std::array<int, 2>& edge, int first, int second);

/// The same of normals as normals_at gives them.
double fold_angle(const std::array<Vec3, 2>& normals);

/// An angle to compare folds with.
struct FoldLimit {
  double degrees;
  double squared_cosine;  ///< 2 from a right angle on, which nothing exceeds

  explicit FoldLimit(double limit);
};

/// Whether a fold is at least this large; for most edges without an arc tangent.
bool folds_by(const std::array<Vec3, 2>& normals, const FoldLimit& limit);

/// The largest fold at the sides of a triangle that is below `crease_angle`: how far the surface that it approximates
/// turns from one facet to the next. 0 for a facet of a plane.
double turn_of_surface(const EdgeSurroundings& around, int triangle, double crease_angle);

/// The height of a triangle over its longest side.
double height_of(const EdgeSurroundings& around, int triangle);

}  // namespace epura::edges
