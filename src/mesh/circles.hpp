// Circles among the edges of a mesh: what rims of holes, bosses and shafts are made of.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace epura {

/// Edges that run round on a circle. Coordinates of the model's file.
struct MeshCircle {
  Vec3 centre;
  Vec3 axis;  ///< unit normal of its plane
  double radius;
  double deviation;           ///< of its vertices from the circle, at most
  std::vector<int> vertices;  ///< in order round it; of a whole circle the first one is not repeated
  bool whole;                 ///< closed; otherwise an arc
};

/// Whole circles and arcs (60 degrees at least, 5 edges at least) among creases and boundaries of `crease_angle`
/// degrees or more. Each vertex of a circle lies within `tolerance` times its radius of it. In order of their first
/// vertices.
std::vector<MeshCircle> find_circles(const Mesh& mesh, double crease_angle = 30, double tolerance = 1e-3);

}  // namespace epura
