// SPDX-License-Identifier: Apache-2.0
// Triangles with similar extents, separated by position and depth where cells of the page cannot.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "search/bounds_tree.hpp"
#include "view/projected_scene.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/pile.hpp"
#include "visibility/seen_from.hpp"

namespace epura::visibility {

/// A tree of bounds between parallel planes (Kay & Kajiya, Ray tracing complex scenes, SIGGRAPH 1986), in directions
/// that the largest triangle gives: aside from each of its sides, and the height over its plane. So slanted lines side
/// by side, and tilted plates on one another, are distinguished however near they are. What lies in one plane, or on
/// one line, hides nothing there (Contact::touching), and is passed by at once.
///
/// The lowest over that plane come first: of those before an edge, these are the next to it. In a stack they hide
/// nearly all of it, where from the top on each would hide a little more than the one before. Where at least half meet
/// in one place of the page, they stand in order around it. Of many triangles with one footprint on the page, a pile is
/// one thing.
class CandidateTree {
 public:
  using Bounds = epura::search::Bounds<6>;

  CandidateTree() = default;
  /// Of triangles with an area on the page grid.
  CandidateTree(const view::ProjectedScene& view, std::vector<int> triangles);

  [[nodiscard]] bool empty() const { return tree_.empty(); }

  /// Where triangles have to reach to hide something of an edge between two places: x, y and depth. Those that have an
  /// end of it as a corner may hide it from elsewhere.
  [[nodiscard]] Bounds before(const view::ProjectedScene& view, const PageEdge& edge,
                              const std::array<Vec3, 2>& places) const;

  /// Calls `visit(triangle)` or `visit(pile)` for those that may reach into the bounds, until it returns false. It may
  /// narrow the bounds.
  template <class Visit>
  void visit(const Bounds& wanted, Visit visit) const {
    tree_.visit_where([&](const Bounds& bounds) { return meet(bounds, wanted); },
                      [&](std::size_t i) { return visit_thing(i, visit); });
  }

  /// Calls `visit(triangle)` for those that have an end of the edge as a corner and may lie over it.
  template <class Visit>
  void visit_joined(const view::ProjectedScene& view, const PageEdge& edge, const Visit& visit) const {
    for (const int end : {edge.p, edge.q}) {
      if (!hub_ || !hub_->is_at(view.grid[end])) {
        for (const auto& [vertex, triangle] : joined_at(end)) visit(triangle);
        continue;
      }
      const Turn towards = hub_->of_edge(view, edge);
      tree_.visit_where([&](const Bounds& bounds) { return turns_meet(bounds[turn], towards); },
                        [&](std::size_t i) {
                          visit_joined_of(view, things_[i], end, visit);
                          return true;
                        });
    }
  }

 private:
  static constexpr std::size_t height = 3;  ///< over the plane of the largest triangle
  static constexpr std::size_t depth = 4;   ///< over the flattest plane through the side of the longest one
  static constexpr std::size_t turn = 5;    ///< around the hub
  static constexpr std::size_t directions = 5;

  static bool meet(const Bounds& a, const Bounds& b) {
    for (std::size_t i = 0; i < directions; ++i)
      if (a[i][0] > b[i][1] || a[i][1] < b[i][0]) return false;
    return turns_meet(a[turn], b[turn]);
  }

  template <class Visit>
  bool visit_thing(std::size_t i, const Visit& visit) const {
    return things_[i] >= 0 ? visit(things_[i]) : visit(piles_[~things_[i]]);
  }
  template <class Visit>
  void visit_joined_of(const view::ProjectedScene& view, int thing, int end, const Visit& visit) const {
    if (thing < 0) {
      for (const int triangle : piles_[~thing].around(end)) visit(triangle);
      return;
    }
    const auto& corners = view.triangles[thing].vertex;
    if (std::find(corners.begin(), corners.end(), end) != corners.end()) visit(thing);
  }

  [[nodiscard]] std::span<const std::pair<int, int>> joined_at(int vertex) const;
  void choose_directions(const view::ProjectedScene& view, const std::vector<int>& triangles);
  void note_corners(const view::ProjectedScene& view, const std::vector<int>& triangles);
  void make_piles(const view::ProjectedScene& view, std::vector<int> triangles);
  [[nodiscard]] Bounds bounds_of(const view::ProjectedScene& view, int triangle) const;
  [[nodiscard]] Bounds bounds_of_thing(const view::ProjectedScene& view, int thing) const;
  void make_tree(const view::ProjectedScene& view);

  std::vector<int> things_;  ///< triangles, or ~numbers of piles
  std::vector<Pile> piles_;
  std::vector<std::pair<int, int>> joined_;  ///< vertex and triangle, ascending; without vertices at the hub
  std::array<Vec3, directions> directions_{};
  std::array<double, directions> slack_{};
  double touching_ = 0;
  std::optional<SeenFrom> hub_;
  search::BoundsTree<6> tree_;
};

}  // namespace epura::visibility
