// SPDX-License-Identifier: Apache-2.0
// Triangles that lie much alike, told apart by place and depth where cells of the page cannot do so.
#pragma once

#include <array>
#include <vector>

#include "view/view.hpp"
#include "visibility/bounds_tree.hpp"
#include "visibility/pile.hpp"

namespace epura {

/// A tree of bounds between parallel planes (Kay & Kajiya, Ray tracing complex scenes, SIGGRAPH 1986), in directions
/// that the largest triangle gives: aside from each of its sides, and the height over its plane. So slanted lines side
/// by side, and tilted plates on one another, are told apart however near they are.
///
/// The lowest over that plane come first: of those before an edge, these are the next to it. In a stack they hide
/// nearly all of it, where from the top on each would hide a little more than the one before. Of many triangles with
/// one footprint on the page, a pile is one thing.
class CandidateTree {
 public:
  using Bounds = epura::Bounds<5>;

  CandidateTree() = default;
  /// Of triangles with an area on the page grid.
  CandidateTree(const View& view, std::vector<int> triangles);

  [[nodiscard]] bool empty() const { return tree_.empty(); }

  /// Where triangles have to reach to hide something between two places: x, y and depth.
  [[nodiscard]] Bounds before(const Vec3& a, const Vec3& b) const;

  /// Calls `visit(triangle)` or `visit(pile)` for those that may reach into the bounds, until it returns false. It may
  /// narrow the bounds.
  template <class Visit>
  void visit(const Bounds& wanted, Visit visit) const {
    tree_.visit(wanted,
                [&](std::size_t i) { return things_[i] >= 0 ? visit(things_[i]) : visit(piles_[~things_[i]]); });
  }

 private:
  void choose_directions(const View& view, const std::vector<int>& triangles);
  void make_piles(const View& view, std::vector<int> triangles);
  [[nodiscard]] Bounds bounds_of(const View& view, int triangle) const;
  [[nodiscard]] Bounds bounds_of_thing(const View& view, int thing) const;
  void sort(const View& view);

  std::vector<int> things_;  ///< triangles, or ~numbers of piles
  std::vector<Pile> piles_;
  std::array<Vec3, 5> directions_{};
  std::array<double, 5> slack_{};
  BoundsTree<5> tree_;
};

}  // namespace epura
