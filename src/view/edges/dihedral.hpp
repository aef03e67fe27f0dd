// SPDX-License-Identifier: Apache-2.0
// Computes the fold angle between two triangles at their common edge, whatever their orientation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "world/world.hpp"

namespace epura::edges {

/// One model of a world, with the data needed to classify its edges.
struct EdgeSurroundings {
  const world::World& world;
  int model;
  double normalisation;  ///< power of two that scales lengths to about 1, so that their products stay in range
  /// The mesh before it was cut by a plane, if it is to be judged instead: edges and triangles below are those of this
  /// mesh then.
  const mesh::Mesh* uncut = nullptr;
  /// By triangle of the drawn mesh: how its surface turns it on the page (refine/facing.hpp); empty if no surface is
  /// known.
  std::span<const signed char> facing{};

  /// 1 if a triangle turns counterclockwise, -1 if clockwise, 0 if only the page tells.
  [[nodiscard]] int facing_of(int triangle) const {
    return facing.empty() || uncut != nullptr ? 0 : facing[static_cast<std::size_t>(triangle)];
  }
  [[nodiscard]] const mesh::Mesh& mesh() const { return uncut != nullptr ? *uncut : *world.models[model].mesh; }
  /// The corners of a triangle, as vertices of the world.
  [[nodiscard]] std::array<int, 3> corners(int triangle) const {
    if (uncut == nullptr) return world.triangles[world.first_triangle[model] + triangle];
    std::array<int, 3> corners = uncut->triangle(triangle);
    for (int& v : corners) v += world.first_vertex[model];
    return corners;
  }
  [[nodiscard]] Vec3 point(int vertex) const { return world.points[vertex] * normalisation; }
  /// The corner of a triangle that is not on the edge. Beyond a sliver a triangle may share only a part of the edge
  /// with the triangle before it; the result is then the corner farthest from the line of the edge.
  [[nodiscard]] int apex(const std::array<int, 2>& edge, int triangle) const;
};

/// A side of a triangle as find_edge expects it.
inline std::array<int, 2> side_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Returns the edge between two vertices of the world, given with the lower number first; null if the model has no such
/// edge.
const mesh::MeshEdge* find_edge(const EdgeSurroundings& around, const std::array<int, 2>& side);

/// Returns the normals of two triangles at their common edge, not normalised; they have equal directions if the
/// triangles are coplanar and do not overlap.
std::array<Vec3, 2> normals_at(const EdgeSurroundings& around, const std::array<int, 2>& edge, int first, int second);

/// The same for triangles whose corners beside the edge are known.
std::array<Vec3, 2> normals_beside(const EdgeSurroundings& around, const std::array<int, 2>& edge,
                                   const std::array<int, 2>& apexes);

/// Returns the angle in degrees by which the second triangle deviates from a flat continuation of the first one: 0
/// flat, 180 folded back.
double fold_angle(const EdgeSurroundings& around, const std::array<int, 2>& edge, int first, int second);

/// The same for normals from normals_at.
double fold_angle(const std::array<Vec3, 2>& normals);

/// A threshold for fold angles.
struct FoldLimit {
  double degrees;
  double squared_cosine;  ///< 2 for 90 degrees and more, so that nothing exceeds it

  explicit FoldLimit(double limit);
};

/// Whether a fold reaches the limit. Most edges are decided without an arc tangent.
bool folds_by(const std::array<Vec3, 2>& normals, const FoldLimit& limit);

/// Returns the largest fold below `crease_angle` at the sides of a triangle, in degrees: how far the surface that it
/// approximates turns from one facet to the next. 0 for a facet of a plane.
double turn_of_surface(const EdgeSurroundings& around, int triangle, double crease_angle);

/// Returns the height of a triangle above its longest side.
double height_of(const EdgeSurroundings& around, int triangle);

}  // namespace epura::edges
