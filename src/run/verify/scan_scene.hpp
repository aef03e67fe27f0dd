// SPDX-License-Identifier: Apache-2.0
// The world, to be cut by lines across the page.
//
// A straight line on the page is a plane through the viewer, m . (a, b) F = s (1 - k c) in the frame of sight.hpp. It
// cuts every triangle in a segment: the scene becomes a set of segments over that line, with depth upwards.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "verify/cover.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

/// A line of the page, mm from ScanScene::origin.
struct ScanLine {
  Vec2 middle, along;  ///< `along` has length 1
  double reach;        ///< examined distance to either side of the middle

  [[nodiscard]] Vec2 position(double u) const { return middle + u * along; }
  [[nodiscard]] Vec2 across() const { return {-along.y, along.x}; }
};

/// Every vertex of the world in one frame.
class ScanScene {
 public:
  /// `precision` is the required precision of positions on the page, mm; `thread_depth` as in EdgeOptions.
  ScanScene(const VerifyInput& input, double precision, double thread_depth);

  const world::World& world;
  Vec2 origin;              ///< position of the point of reference on the page, mm
  double page;              ///< mm of paper per unit of length in the world, at the point of reference
  double depth;             ///< the same for depth
  double k;                 ///< positions on the page are page (a, b) / (1 - k c)
  double min, max;          ///< visible range of c
  UnsetVector<Vec3> local;  ///< (a, b, c) by vertex

  /// Whether a vertex lies in front of the viewer, so that it has a position on the page.
  [[nodiscard]] bool is_before_viewer(int vertex) const { return local[vertex].z < eye_; }
  [[nodiscard]] Vec2 to_page(const Vec3& point) const { return page / (1 - k * point.z) * Vec2(point.x, point.y); }
  [[nodiscard]] Vec2 position(int vertex) const { return to_page(local[vertex]); }
  [[nodiscard]] double depth_of(const Vec3& point) const { return depth * point.z / (1 - k * point.z); }
  /// Whether rounding makes the position of some corner uncertain.
  [[nodiscard]] bool is_vague(int triangle) const;
  /// The same of an edge between two vertices.
  [[nodiscard]] bool is_vague(const std::array<int, 2>& edge) const;
  /// Whether a convention leaves the line of an edge out, or, in part, the surface on which its contour is drawn.
  [[nodiscard]] bool is_left_out(const std::array<int, 2>& edge) const;
  /// Whether facets hide a part of a contour, though their surface does not: it may be drawn or not.
  [[nodiscard]] bool is_hidden_by_facets(const std::array<int, 2>& edge) const;
  /// Whether an edge lies in a limit of depth, where surfaces end without a line.
  [[nodiscard]] bool is_at_limit(const std::array<int, 2>& edge) const;
  /// The part in front of the viewer of an edge between two vertices, on the page; nothing if there is none.
  [[nodiscard]] std::optional<std::array<Vec2, 2>> line_of(const std::array<int, 2>& edge) const;

 private:
  double eye_;
  UnsetVector<char> vague_;
  std::vector<std::array<int, 2>> left_out_, hidden_by_facets_;  ///< ascending
};

}  // namespace epura::verify
