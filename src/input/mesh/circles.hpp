// SPDX-License-Identifier: Apache-2.0
// Finds circles formed by edges of a mesh: rims of holes, bosses and shafts.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "mesh/feature_lines.hpp"

namespace epura::mesh {

/// A chain of edges on a circle.
struct MeshCircle {
  Vec3 centre;
  Vec3 axis;  ///< unit normal of its plane
  double radius;
  double deviation;           ///< greatest distance of its vertices from the circle
  std::vector<int> vertices;  ///< in order along the circle; the first vertex of a whole circle is not repeated
  bool whole;                 ///< closed; otherwise an arc
};

/// Returns whole circles and arcs among boundaries and creases of `crease_angle` degrees or more, sorted by their
/// vertices. A circle begins at its lowest vertex and continues to the lower neighbour, an arc begins at its lower end.
/// The axis is such that both run counterclockwise about it.
///
/// Circles are distinguished from polygons by these rules: there are at least twelve edges per turn on average (with
/// fewer sides, every edge of a regular prism is a crease), an edge spans at most 45 degrees and at most four times the
/// mean (the flat of a shaft does not belong to its arc), and an arc has at least five edges and 60 degrees. Each
/// vertex lies within `tolerance` times the radius of the circle.
std::vector<MeshCircle> find_circles(const PlacedMesh& mesh, double crease_angle = 30, double tolerance = 1e-3);

/// The same, in coordinates of the model's file.
std::vector<MeshCircle> find_circles(const Mesh& mesh, double crease_angle = 30, double tolerance = 1e-3);

}  // namespace epura::mesh
