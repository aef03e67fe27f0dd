// SPDX-License-Identifier: Apache-2.0
// Many pieces in one place, searched by rank, direction and position.
#pragma once

#include <array>
#include <vector>

#include "drawing/ink.hpp"
#include "search/bounds_tree.hpp"

namespace epura::drawing {

/// Positions are measured along and across the longest piece, and across two others in directions as different as
/// possible. This separates parallel lines however close together they are.
class PieceTree {
 public:
  using Bounds = epura::search::Bounds<7>;

  PieceTree() = default;
  /// `spread` is the greatest difference in direction between pieces that cover each other.
  PieceTree(const std::vector<Piece>& pieces, std::vector<int> members, double tolerance, double spread,
            Order has_higher_rank);

  /// Returns the bounds of pieces with higher rank than a piece that may cover some of a part of it, in mm from its
  /// beginning.
  [[nodiscard]] Bounds covering(int piece, const std::array<double, 2>& part) const;

  /// Calls `visit(piece)` for pieces that may reach into the bounds, the lowest in rank first among those with one
  /// direction, until it returns false. `visit` may narrow the bounds.
  template <class Visit>
  void visit(const Bounds& wanted, Visit visit) const {
    tree_.visit(wanted, [&](std::size_t i) { return place_[i] < wanted[order][0] || visit(members_[i]); });
  }

 private:
  // The bounds hold four positions, the direction as a point on the unit circle, and the index in order of rank.
  static constexpr std::size_t direction = 4, order = 6;

  void choose_normals();
  void sort_by_direction();
  [[nodiscard]] Bounds bounds_of(const Vec2& from, const Vec2& to) const;

  const std::vector<Piece>* pieces_ = nullptr;
  std::vector<int> by_rank_;  ///< lowest first
  double tolerance_ = 0, spread_ = 0;
  Order has_higher_rank_ = nullptr;
  std::array<Vec2, 4> normals_{};
  std::vector<int> members_;
  std::vector<double> place_;  ///< index of each member in order of rank
  search::BoundsTree<7> tree_;
};

}  // namespace epura::drawing
