// SPDX-License-Identifier: Apache-2.0
// Draws lines in which recognised surfaces cross on both surfaces instead of on their facets.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/part_edges.hpp"
#include "drawing/places.hpp"

namespace epura::drawing {

/// Where facets of two recognised surfaces cross, and where these surfaces do. A line of crossing bends in nodes; each
/// is moved, by Newton's method, to where all surfaces meet that meet there, and where a contour of one of them ends in
/// it, to where its normal is perpendicular to the projectors. Nodes stay that would move farther than the heights of
/// the facets explain. Parallel projections only.
class ExactCrossings {
 public:
  /// Refers to both.
  ExactCrossings(const PartEdges& edges, const ViewDrawing& drawing);

  /// Where the node at a place on the page is on the surfaces; nothing if there is none, if it stays, or if lines do
  /// not end there, but where something hides them.
  [[nodiscard]] std::optional<Vec2> moved(const Vec2& place) const;

  /// Draws the crossings in a line within `tolerance` mm of those of the surfaces. Returns whether there are any.
  bool refine(Chain& chain, double tolerance) const;

 private:
  using Pair = std::array<const surfaces::PartFace*, 2>;
  /// A line of crossing from a node.
  struct Way {
    Vec2 to;
    Pair pair;
  };
  struct Node {
    Vec3 in_mesh;
    bool is_cut = true;  ///< no line of crossing ends there: something hides the rest of it
    std::vector<Way> ways{};
    std::vector<const surfaces::PartFace*> faces{};     ///< those that meet there; null for one that is not recognised
    std::vector<const surfaces::PartFace*> contours{};  ///< of these, whose contours end there
    std::optional<Vec3> exact{};
  };

  [[nodiscard]] Vec2 on_page(const Vec3& point) const { return Vec2(drawing_.world_to_page * Vec4(point, 1)); }
  [[nodiscard]] const Node* node_at(const Vec2& place) const;
  Node& node_to_add(const Vec2& place, const Vec3& in_mesh);
  void add_crossing(const Segment& segment);
  void add_contour_ends(const Segment& segment);
  [[nodiscard]] std::optional<Vec3> solved(const Node& node) const;
  [[nodiscard]] std::optional<Vec3> on_both(const Vec3& start, const Pair& pair) const;
  [[nodiscard]] const Pair* crossing_between(const Node* node, const Vec2& from, const Vec2& to) const;
  void add_between(const Node& from, const Node& to, const Pair& pair, double tolerance,
                   std::vector<Vec2>& points) const;

  const PartEdges& edges_;
  const ViewDrawing& drawing_;
  Vec3 towards_viewer_;
  double touching_;  // units of the world
  Places<int> number_of_;
  std::vector<Node> nodes_{};
};

}  // namespace epura::drawing
