// SPDX-License-Identifier: Apache-2.0
// Finds the triangles that may hide an edge by position and depth, where many have similar extents and the cells of the
// page do not separate them.
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

/// A tree of bounds between parallel planes (Kay & Kajiya, Ray tracing complex scenes, SIGGRAPH 1986). The directions
/// come from the largest triangle: perpendicular to each of its sides on the page, and the height over its plane. This
/// separates parallel slanted lines and stacked tilted plates however close together they are. Triangles that lie in
/// one plane or on one line with an edge hide none of it (Contact::touching) and are skipped at once.
///
/// The lowest triangles over that plane are visited first: of those in front of an edge, these are the nearest. In a
/// stack, they hide nearly all of the edge, whereas from the top, each triangle would hide only a little more than the
/// one before. Where at least half of the triangles meet in one point of the page (a hub), they are also ordered by
/// direction around it. Many triangles with the same footprint on the page form one entry, a pile.
class CandidateTree {
 public:
  using Bounds = epura::search::Bounds<6>;

  CandidateTree() = default;
  /// Triangles must have an area on the page grid.
  CandidateTree(const view::ProjectedScene& view, std::vector<int> triangles);

  [[nodiscard]] bool empty() const { return tree_.empty(); }

  /// Returns the bounds that a triangle must reach into to hide part of an edge between two places (x, y and depth).
  /// Triangles that have an end of the edge as a corner may hide it without reaching into these bounds.
  [[nodiscard]] Bounds before(const view::ProjectedScene& view, const PageEdge& edge,
                              const std::array<Vec3, 2>& places) const;

  /// Calls `visit(triangle)` or `visit(pile)` for those that may reach into the bounds, until it returns false. `visit`
  /// may narrow the bounds.
  template <class Visit>
  void visit(const Bounds& wanted, Visit visit) const {
    tree_.visit_where([&](const Bounds& bounds) { return meet(bounds, wanted); },
                      [&](std::size_t i) { return visit_thing(i, visit); });
  }

  /// Calls `visit(triangle)` for the triangles that have an end of the edge as a corner and may overlap it on the page.
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
  static constexpr std::size_t depth = 4;   ///< over the flattest plane through the longest side on the page
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
