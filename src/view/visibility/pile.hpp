// SPDX-License-Identifier: Apache-2.0
// Triangles with the same corners on the page lattice, such as those of equal parts behind one another.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "search/bounds_tree.hpp"
#include "view/projected_scene.hpp"

namespace epura::visibility {

/// Whether they cover an edge is decided once for all. If their corners are the same to the last bit, they cover the
/// same part of the edge: one triangle that hides all of it suffices, and depth tells which others may hide some.
class Pile {
 public:
  /// Corners on the page grid, in the order of their numbers.
  using Footprint = std::array<int, 6>;
  static Footprint footprint(const view::ProjectedScene& view, int triangle);

  /// Least and greatest depth of several triangles at each corner.
  using Depths = search::Bounds<3>;

  /// The triangles must have the same footprint.
  Pile(const view::ProjectedScene& view, std::vector<int> triangles);

  /// Nearest first.
  [[nodiscard]] const std::vector<int>& triangles() const { return triangles_; }
  /// Whether the corners are the same to the last bit.
  [[nodiscard]] bool is_exact() const { return !tree_.empty(); }
  /// The corners of the first triangle, in the order of Depths.
  [[nodiscard]] const std::array<int, 3>& corners() const { return corners_; }
  /// The triangles that have this vertex as a corner.
  [[nodiscard]] std::vector<int> around(int vertex) const;

  /// Calls `visit(triangle)` for those for whose depths `may_hide` returns true, until `visit` returns false.
  template <class MayHide, class Visit>
  void visit(const MayHide& may_hide, const Visit& visit) const {
    tree_.visit_where(may_hide, [&](std::size_t i) { return visit(triangles_[i]); });
  }

 private:
  std::vector<int> triangles_;
  std::array<int, 3> corners_{};
  std::vector<std::pair<int, int>> around_;  ///< vertex and triangle, ascending
  search::BoundsTree<3> tree_;               ///< empty where corners differ
};

}  // namespace epura::visibility
