// SPDX-License-Identifier: Apache-2.0
// Splits the triangles of a world along the borders between the regions of a cutting surface.
#pragma once

#include <vector>

#include "cut/cutting_surface.hpp"
#include "world/world.hpp"

namespace epura::cut {

/// A world with the same surfaces, of which each triangle and wire lies in one region. The meshes are derived from
/// those of the files (Mesh::uncut), and have vertices where borders cross edges.
struct SplitWorld {
  world::World world;
  std::vector<int> region_of_triangle;  ///< of the split world
  double slack;                         ///< points closer to a border, in units of the world, are on it
};

/// A triangle within a border belongs to the region on the side of the material.
SplitWorld split_world(const world::World& world, const CuttingSurface& surface);

/// Where the segment between two points crosses a plane, from their distances to it, which have opposite signs. The
/// result does not depend on the order of the points.
struct CutPoint {
  Vec3 point;
  double t;  ///< from the first point to the second
};
CutPoint cut_point(const Vec3& a, const Vec3& b, const std::array<double, 2>& distances, double normalisation);

/// The origin in the file of a vertex at parameter t on an edge of a mesh that may be split already.
mesh::CutVertex cut_vertex_on(const mesh::Mesh& mesh, const std::array<int, 2>& edge, double t);

}  // namespace epura::cut
