// SPDX-License-Identifier: Apache-2.0
// A mesh as recognition sees it: facets that are flat within the precision of the file's coordinates, and their
// neighbours. All questions of recognition to a mesh are answered here.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace epura::surfaces {

/// Triangles that form one flat piece, or a polygon of the file.
struct Facet {
  Vec3 normal;  ///< unit; zero if it has no area
  Vec3 middle;  ///< mean of its supports
  double area;
  double width;   ///< of its thickest triangle; of a plane, its least extent
  bool is_plane;  ///< has more corners than a facet of a round surface can have, if other faces do not cut it off
};

/// One side of a triangle.
struct Side {
  int neighbour = -1;  ///< the only other triangle of its body there; -1 if there is none, or several
  int edge = -1;       ///< of the mesh
};

struct Facets {
  Vec3 origin;       ///< centre of the file's bounding box, which is the origin of `points`
  double scale;      ///< power of two: `points` are those of the file, less the origin, times this; they extend over
                     ///< about 1
  double tolerance;  ///< greatest distance at which a point counts as lying on a surface
  double slack;      ///< residuals that a face rises at least over its facets
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> corners;  ///< of triangles, which turn like their neighbours
  std::vector<std::array<Side, 3>> sides;   ///< of triangles; side i from corner i to the next
  std::vector<Vec3> normals;                ///< unit, of triangles; zero if they have no area
  std::vector<int> facet_of;                ///< of triangles
  std::vector<Facet> facets;
  std::vector<int> first_triangle, triangles;  ///< of each facet
  std::vector<int> first_vertex, vertices;     ///< of each facet
  std::vector<int> end_of_supports;            ///< of each facet: an index into `vertices`

  [[nodiscard]] std::span<const int> triangles_of(int facet) const {
    return {triangles.data() + first_triangle[facet], triangles.data() + first_triangle[facet + 1]};
  }
  [[nodiscard]] std::span<const int> vertices_of(int facet) const {
    return {vertices.data() + first_vertex[facet], vertices.data() + first_vertex[facet + 1]};
  }
  /// The vertices of a facet, less those that say nothing about a round surface: those inside a straight edge between
  /// two facets may lie anywhere on a chord of it, and those at the ends of a strip anywhere in the strip's plane where
  /// another face cuts it off.
  [[nodiscard]] std::span<const int> supports_of(int facet) const {
    return {vertices.data() + first_vertex[facet], vertices.data() + end_of_supports[facet]};
  }
  /// The ends of side `side` of a triangle, and their distance.
  [[nodiscard]] std::array<Vec3, 2> ends_of(int triangle, int side) const {
    return {points[corners[triangle][side]], points[corners[triangle][(side + 1) % 3]]};
  }
  [[nodiscard]] double length_of(int triangle, int side) const {
    const std::array<Vec3, 2> ends = ends_of(triangle, side);
    return glm::distance(ends[0], ends[1]);
  }
  /// Calls visit(triangle, side, other) for each side of a facet's triangles with exactly one other triangle, if that
  /// belongs to another facet.
  template <class Visit>
  void for_sides(int facet, const Visit& visit) const {
    for (const int t : triangles_of(facet))
      for (int side = 0; side < 3; ++side)
        if (const int next = sides[t][side].neighbour; next >= 0 && facet_of[next] != facet)
          visit(t, side, facet_of[next]);
  }
  /// The cosine of the fold between two facets at a side of the first one's triangle. The orientation of the triangles
  /// does not matter.
  [[nodiscard]] double cosine_of_fold(int triangle, int side) const;
  /// The tangent of half of that angle.
  [[nodiscard]] double fold_at(int triangle, int side) const;
  /// Whether rounding decides in which direction the facet faces.
  [[nodiscard]] bool is_sliver(int facet) const { return facets[facet].width <= 16 * tolerance; }
};

Facets make_facets(const mesh::Mesh& mesh);

}  // namespace epura::surfaces
