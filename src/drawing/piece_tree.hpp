// SPDX-License-Identifier: Apache-2.0
// Many pieces in one place, searched by rank, direction and position.
#pragma once

#include <array>
#include <vector>

#include "drawing/ink.hpp"
#include "search/bounds_tree.hpp"

namespace epura::drawing {

/// Places are measured along and across the longest piece, and across two others in the most different directions. So
/// parallel lines are separated however close they are.
class PieceTree {
 public:
  using Bounds = epura::search::Bounds<7>;

  PieceTree() = default;
  /// `spread` is by how much pieces may differ in direction that cover each other.
  PieceTree(const std::vector<Piece>& pieces, std::vector<int> members, double tolerance, double spread);

  /// What is of higher rank than a piece and may cover something of a part of it, in mm from its beginning.
  [[nodiscard]] Bounds covering(int piece, const std::array<double, 2>& part) const;

  /// Calls `visit(piece)` for those that may meet the bounds, of one direction the lowest in rank first, until it
  /// returns false. It may narrow the bounds.
  template <class Visit>
  void visit(const Bounds& wanted, Visit visit) const {
    tree_.visit(wanted, [&](std::size_t i) { return place_[i] < wanted[order][0] || visit(members_[i]); });
  }

 private:
  // What is measured: four places, the direction as a point of the unit circle, and the place in order of rank.
  static constexpr std::size_t direction = 4, order = 6;

  void choose_normals();
  void sort_by_direction();
  [[nodiscard]] Bounds bounds_of(const Vec2& from, const Vec2& to) const;

  const std::vector<Piece>* pieces_ = nullptr;
  std::vector<int> by_rank_;  ///< the lowest first
  double tolerance_ = 0, spread_ = 0;
  std::array<Vec2, 4> normals_{};
  std::vector<int> members_;
  std::vector<double> place_;  ///< of members in order of rank
  search::BoundsTree<7> tree_;
};

}  // namespace epura::drawing
