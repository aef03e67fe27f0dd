// SPDX-License-Identifier: Apache-2.0
// Circles formed by edges of a mesh: rims of holes, bosses and shafts.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "mesh/feature_lines.hpp"

namespace epura::mesh {

/// Edges that run round on a circle.
struct MeshCircle {
  Vec3 centre;
  Vec3 axis;  ///< unit normal of its plane
  double radius;
  double deviation;           ///< of its vertices from the circle, at most
  std::vector<int> vertices;  ///< in order round it; of a whole circle the first one is not repeated
  bool whole;                 ///< closed; otherwise an arc
};

/// Whole circles and arcs among creases of `crease_angle` degrees or more and boundaries, in order of their vertices. A
/// circle begins at its lowest vertex and continues to the lower neighbour, an arc begins at its lower end; both run
/// counterclockwise about their axis.
///
/// What is a circle and what a polygon: there are twelve edges a turn or more on average (of a regular prism with
/// fewer sides every edge is a crease), an edge takes at most 45 degrees and at most four times as much as the mean
/// (the flat of a shaft is none of its arc), and an arc has five edges and 60 degrees at least. Each vertex lies within
/// `tolerance` times the radius of the circle.
std::vector<MeshCircle> find_circles(const PlacedMesh& mesh, double crease_angle = 30, double tolerance = 1e-3);

/// The same in coordinates of the model's file.
std::vector<MeshCircle> find_circles(const Mesh& mesh, double crease_angle = 30, double tolerance = 1e-3);

}  // namespace epura::mesh
