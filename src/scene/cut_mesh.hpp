// SPDX-License-Identifier: Apache-2.0
// Computes the remainder of one model behind a plane, and the segments along which the plane cuts it.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/scene.hpp"

namespace epura::scene {

/// The sides of a plane on which the vertices of a world lie.
struct Sides {
  double normalisation;          ///< power of two that scales the world's size to about 1
  std::vector<signed char> of;   ///< 1: removed, -1: kept, 0: on the plane
  std::vector<double> distance;  ///< from the plane, normalised
};

Sides find_sides(const World& world, const CuttingPlane& plane);

/// A segment of a cut, lower vertex first.
struct CutSegment {
  int body;
  std::array<int, 2> vertex;
  int sense = 0;      ///< 1: viewed from the removed side, material is left of it towards the higher vertex; -1: right
  int triangle = -1;  ///< triangle of the uncut mesh that was cut there

  /// Compares body and vertices only.
  auto operator<=>(const CutSegment& other) const {
    return body != other.body ? body <=> other.body : vertex <=> other.vertex;
  }
  bool operator==(const CutSegment& other) const { return body == other.body && vertex == other.vertex; }
};

/// Vertices are numbered within the model: those of its file, then new ones.
struct CutMesh {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> polygon, body;  ///< of each triangle
  std::vector<Vec3> points;        ///< of new vertices
  std::vector<mesh::CutVertex> vertices;
  std::vector<CutSegment> segments;  ///< one for each triangle that has a side in the cut, just behind the plane
  std::vector<int> in_plane;         ///< triangles of the uncut mesh in the plane; not in `triangles`
  std::vector<int> uncut;            ///< those of `triangles` that belong to bodies which the plane passes through
  std::vector<std::array<int, 2>> wires;
  bool cuts_wires = false;
};

CutMesh cut_mesh(const World& world, int model, const Sides& sides);

/// Sorts segments and removes pairs of equal ones, where an even number of faces meets.
void keep_odd(std::vector<CutSegment>& segments);

}  // namespace epura::scene
