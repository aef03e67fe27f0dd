// SPDX-License-Identifier: Apache-2.0
// Finds triangles too low to be meaningful, and determines how a surface continues across them.
//
// The normal of a sliver is determined by rounding: of the file, of doubles, or of the page lattice. Edges next to
// slivers are judged by the faces beyond them, and of several edges along one line, one is drawn. The longest side of a
// sliver lies on the other two, which are drawn instead. If two sides are equal within the height of the sliver (the
// long sides of a needle, as at the pole of a surface of revolution), the shorter one is drawn. A strict order of all
// sides prevents the two rules from removing both.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "edges/dihedral.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

/// The continuation of a surface at an edge.
struct Beyond {
  std::optional<int> triangle;  ///< number in the model; nothing if the surface ends
  bool covered = false;         ///< another side of a sliver is drawn in place of the edge
};

/// The exit from a triangle.
struct Exit {
  std::array<int, 2> side;
  std::optional<int> next;  ///< the triangle beyond the side, if there is exactly one
};

/// Decides which triangles of a model are slivers in a view. Those of which a surface tells how they turn are none.
class SliverRule {
 public:
  SliverRule(const EdgeSurroundings& around, const view::ProjectedScene& view);

  [[nodiscard]] bool holds_for(int triangle) const;

 private:
  [[nodiscard]] bool is_of_a_step(int triangle) const;

  EdgeSurroundings around_;
  const view::ProjectedScene* view_;
  double lowest_, on_page_;
};

/// The slivers of one model in one view.
class Slivers {
 public:
  /// For few queries: triangles are tested on demand. The view must outlive this object.
  Slivers(const EdgeSurroundings& around, const SliverRule& rule) : around_(around), rule_(rule) {}
  /// For many queries: all triangles are tested in advance. Throws OutOfTime.
  Slivers(const EdgeSurroundings& around, const view::ProjectedScene& view, const Progress& progress = {});
  /// For tests: exactly these slivers.
  Slivers(const EdgeSurroundings& around, std::vector<char> slivers)
      : around_(around), is_sliver_(std::move(slivers)) {}

  [[nodiscard]] bool contain(int triangle) const {
    return rule_ ? rule_->holds_for(triangle) : is_sliver_[triangle] != 0;
  }

  /// Returns the first triangle that is not a sliver, starting with this one and moving away from the edge. Each sliver
  /// is left through the side on which the middle of the edge lies.
  [[nodiscard]] Beyond beyond(const std::array<int, 2>& edge, int triangle) const {
    return contain(triangle) ? across(edge, triangle) : Beyond{triangle, false};
  }
  /// The same; slivers on the way are appended to `passed`.
  [[nodiscard]] Beyond across(const std::array<int, 2>& edge, int triangle, std::vector<int>* passed = nullptr) const;

  /// Returns the side of a triangle, other than the edge, on which the middle of the edge lies.
  [[nodiscard]] Exit way_out(const std::array<int, 2>& edge, int triangle) const;

 private:
  EdgeSurroundings around_;
  std::optional<SliverRule> rule_;
  std::vector<char> is_sliver_;  ///< by triangle; used if there is no rule
};

}  // namespace epura::edges
