// SPDX-License-Identifier: Apache-2.0
// The remainder of one model behind a plane, and the segments along which the plane cuts it.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/scene.hpp"

namespace epura::scene {

/// The vertices of a world as a plane has them.
struct Sides {
  double normalisation;          ///< power of two that brings the world's size near 1
  std::vector<signed char> of;   ///< 1: removed, -1: kept, 0: on the plane
  std::vector<double> distance;  ///< from the plane, normalised
};

Sides find_sides(const World& world, const CuttingPlane& plane);

/// A segment of a cut, lower vertex first.
struct CutSegment {
  int body;
  std::array<int, 2> vertex;
  int sense = 0;  ///< 1: seen from in front of the plane, material is left of it, going to the higher vertex; -1: right
  int triangle = -1;  ///< of the uncut mesh, that was cut there

  /// By what is cut where.
  auto operator<=>(const CutSegment& other) const {
    return body != other.body ? body <=> other.body : vertex <=> other.vertex;
  }
  bool operator==(const CutSegment& other) const { return body == other.body && vertex == other.vertex; }
};

/// Vertices are numbers of the model: those of its file, then new ones.
struct CutMesh {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> polygon, body;  ///< of each triangle
  std::vector<Vec3> points;        ///< of new vertices
  std::vector<mesh::CutVertex> vertices;
  std::vector<CutSegment> segments;  ///< one for each triangle that is cut just behind the plane
  std::vector<int> in_plane;         ///< triangles of the uncut mesh that lie in the plane; not among `triangles`
  std::vector<int> uncut;            ///< those of `triangles` that belong to bodies which the plane passes through
  std::vector<std::array<int, 2>> wires;
  bool cuts_wires = false;
};

CutMesh cut_mesh(const World& world, int model, const Sides& sides);

/// Sorts segments and removes pairs of equal ones: an even number of faces meets there.
void keep_odd(std::vector<CutSegment>& segments);

}  // namespace epura::scene
