// SPDX-License-Identifier: Apache-2.0
// Computes the remainder of one model behind a plane, and the segments along which the plane cuts it.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "scene/cutting_plane.hpp"
#include "world/world.hpp"

namespace epura::cut {

/// The sides of a plane on which the vertices of a world lie.
struct Sides {
  double normalisation;          ///< power of two that scales the world's size to about 1
  std::vector<signed char> of;   ///< 1: removed, -1: kept, 0: on the plane
  std::vector<double> distance;  ///< from the plane, normalised
};

/// Returns the power of two that scales the world's size to about 1.
double normalisation_of(const world::World& world);

/// Vertices closer to a plane than this, in units of the world, are on it.
double slack_of(const world::World& world);

Sides find_sides(const world::World& world, const scene::CuttingPlane& plane);

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
  std::vector<int> source;         ///< of each triangle, the triangle of the uncut mesh of which it is a part
  std::vector<Vec3> points;        ///< of new vertices
  std::vector<mesh::CutVertex> vertices;
  std::vector<CutSegment> segments;  ///< one for each triangle that has a side in the cut, just behind the plane
  std::vector<int> in_plane;         ///< triangles of the uncut mesh in the plane; not in `triangles`
  std::vector<int> uncut;            ///< those of `triangles` that belong to bodies which the plane passes through
  std::vector<std::array<int, 2>> wires;
  bool cuts_wires = false;
};

/// Returns by body whether it stays whole though parts of it are removed (World::styles); empty if none does.
/// `remains(triangle, vertex)` returns 1 for a vertex on the kept side, -1 on the removed side, 0 on the plane.
template <class Remains>
std::vector<bool> whole_bodies(const world::World& world, int model, const Remains& remains) {
  const auto stays = [](const scene::StyleDescription& style) { return !style.cut.value_or(true); };
  std::vector<bool> whole;
  const std::span<const scene::StyleDescription> styles = world.styles_of(model);
  if (std::none_of(styles.begin(), styles.end(), stays)) return whole;
  const mesh::Mesh& mesh = *world.models[static_cast<std::size_t>(model)].mesh;
  std::vector<std::array<bool, 2>> has(styles.size());  // removed parts, kept parts
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int vertex : mesh.triangle(t))
      if (const int side = remains(t, vertex); side != 0) has[mesh.body[t]][side > 0 ? 1 : 0] = true;
  for (std::size_t body = 0; body < styles.size(); ++body)
    whole.push_back(stays(styles[body]) && has[body][0] && has[body][1]);
  return whole;
}

/// Bodies that are `whole` are not cut; by default those that the plane passes through and styles leave whole.
CutMesh cut_mesh(const world::World& world, int model, const Sides& sides, std::optional<std::vector<bool>> whole = {});

/// Sorts segments and removes pairs of equal ones, where an even number of faces meets.
void keep_odd(std::vector<CutSegment>& segments);

}  // namespace epura::cut
