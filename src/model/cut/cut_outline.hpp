// SPDX-License-Identifier: Apache-2.0
// Outlines in the plane of a cut.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cut/cut_mesh.hpp"
#include "mesh/even_odd.hpp"

namespace epura::cut {

/// The cutting plane with its own coordinates: normalised, with the origin near the middle of the world.
struct PlaneFrame {
  scene::CuttingPlane plane;
  double normalisation;
  Vec3 origin;  ///< in the plane, normalised

  PlaneFrame(const world::World& world, const scene::CuttingPlane& cutting_plane, double normalisation_factor);
  [[nodiscard]] Vec2 flat(const Vec3& point) const {
    const Vec3 l = point * normalisation - origin;
    return {glm::dot(plane.right, l), glm::dot(plane.up, l)};
  }
  [[nodiscard]] Vec3 in_space(const Vec2& p) const {
    return (origin + p.x * plane.right + p.y * plane.up) / normalisation;
  }
};

/// The vertices of one model: those of its file, then those of the cut.
struct CutPlaces {
  std::span<const Vec3> file, made;

  [[nodiscard]] const Vec3& operator[](int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return v < file.size() ? file[v] : made[v - file.size()];
  }
};

/// Calls `visit(body, segments)` for the segments of each body. The segments must be sorted.
template <class Visit>
void visit_bodies(std::span<const CutSegment> segments, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
    while (end < segments.size() && segments[end].body == segments[begin].body) ++end;
    visit(segments[begin].body, segments.subspan(begin, end - begin));
  }
}

/// Segments with the positions of their vertices in the plane.
struct FlatOutlines {
  std::vector<int> vertices;  ///< vertex of each position
  mesh::Outlines outlines;
};
FlatOutlines flatten(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame);

/// Converts segments, of which an even number meets in each vertex, to closed rings of vertices.
std::vector<std::vector<int>> rings_of(std::span<const CutSegment> segments);

/// Returns which of the triangles, all in the plane, lie inside outlines that run along some of their sides. Neighbours
/// without an outline between them have the same result.
std::vector<bool> lie_inside(std::span<const std::array<int, 3>> triangles, std::span<const CutSegment> segments,
                             const CutPlaces& places, const PlaneFrame& frame);

}  // namespace epura::cut
