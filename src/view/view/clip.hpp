// SPDX-License-Identifier: Apache-2.0
// Clipping in homogeneous view coordinates, before any division (seed 003, step 7).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/unset_vector.hpp"
#include "view/view_map.hpp"

namespace epura::view {

/// Points with x * X + y * Y + z * Z + w * W >= 0 lie inside.
struct ClipPlane {
  double x, y, z, w;

  [[nodiscard]] double operator()(const Mapped& p) const { return x * p.x + y * p.y + z * p.z + w * p.w; }
};

/// The part of an edge that remains: its ends as vertices, and their parameters on the edge in space (0 to 1).
struct ClippedEdge {
  std::array<int, 2> vertex;
  std::array<double, 2> t;
};

/// Vertices in homogeneous view coordinates, and planes to cut by. Each cut of an edge creates one new vertex,
/// whichever polygon asks for it: it is computed from the edge's ends in ascending order, so neighbours stay joined.
class Clipper {
 public:
  UnsetVector<Mapped> vertices;

  /// Returns the number that identifies the plane below.
  int add_plane(const ClipPlane& plane);
  /// Returns the part of a polygon inside all of `planes`. The parts of a concave polygon are connected by edges in the
  /// planes that are passed twice [Sutherland, Hodgman. Reentrant Polygon Clipping. CACM 1974].
  std::vector<int> clip_ring(std::vector<int> ring, std::span<const int> planes);
  /// Appends the part of a triangle inside all of `planes`, as triangles.
  void clip_triangle(const std::array<int, 3>& corners, std::span<const int> planes,
                     std::vector<std::array<int, 3>>& pieces);
  /// Returns the part of the edge a, b inside all of `planes`.
  std::optional<ClippedEdge> clip_edge(int a, int b, std::span<const int> planes);
  [[nodiscard]] bool inside(int plane, int vertex) const { return planes_[plane](vertices[vertex]) >= 0; }

 private:
  /// The parameter from a to b (0 to 1) at which the plane cuts.
  [[nodiscard]] double cut_parameter(int plane, int a, int b) const;
  int cut(int plane, int a, int b);

  std::vector<ClipPlane> planes_;
  std::vector<std::unordered_map<std::uint64_t, int>> cuts_;  ///< for each plane: edge -> vertex
};

}  // namespace epura::view
