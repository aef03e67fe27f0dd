// SPDX-License-Identifier: Apache-2.0
// Which pieces of a drawing lie near each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/groups.hpp"
#include "drawing/piece_tree.hpp"
#include "visibility/line_cells.hpp"

namespace epura {

/// Pieces by cell of the paper, within a cell by direction, within a direction by the distance of their lines from the
/// cell's middle.
class PieceGrid {
 public:
  /// `spread` is by how much pieces that are near may differ in direction, radians. Throws OutOfTime.
  PieceGrid(const std::vector<Piece>& pieces, double tolerance, float spread, const Progress& progress = {});

  [[nodiscard]] std::size_t cells() const { return members_.size(); }

  [[nodiscard]] std::size_t cell_of(const Vec2& p) const {
    return static_cast<std::size_t>(grid_.cell(grid_.column(p.x), grid_.row(p.y)));
  }

  [[nodiscard]] bool is_crowded(std::size_t cell) const { return !crowded_.empty() && crowded_[cell] != 0; }

  /// Whether a piece runs through a crowded cell.
  [[nodiscard]] bool is_in_crowd(int piece) const { return !in_crowd_.empty() && in_crowd_[piece] != 0; }

  /// Calls `visit(tree, from, to)` for the cells along a piece in a crowd, with page parameters of the part there.
  template <class Visit>
  void visit_trees(int piece, const Visit& visit) const {
    const Piece& p = pieces_[piece];
    visit_cells(grid_, p.from, p.to, tolerance_,
                [&](int cell, double from, double to) { visit(trees_[tree_of_[cell]], from, to); });
  }

  /// Calls `visit(a, b)` for pairs of pieces in a cell whose lines come near each other and differ little in direction.
  template <class Visit>
  void near_pairs(std::size_t cell, const Visit& visit) const {
    visit_directions(cell, [&](const Member& a, std::span<const Member> others, float turn, float side) {
      for (const Member& b : near(a, others, turn, side)) visit(a.piece, b.piece);
      return true;
    });
  }

 private:
  // Candidates need no more than single precision. `direction` is that of the first of those in one direction.
  struct Member {
    float direction, offset;
    int piece;
  };

  static std::size_t end_of_direction(std::span<const Member> members, std::size_t begin);
  // The first one that is turned so far or farther.
  static std::size_t first_from(std::span<const Member> members, float direction);

  // Calls `visit(member, others, turn, side)` for each member and those of each direction near its own, until it
  // returns false.
  template <class Visit>
  void visit_directions(std::size_t cell, const Visit& visit) const {
    const std::span<const Member> members = members_[cell];
    const float round = half_turn - widest_;
    for (std::size_t a = 0; a < members.size(); a = end_of_direction(members, a)) {
      const auto own = members.subspan(a, end_of_direction(members, a) - a);
      for (std::size_t i = 0; i < own.size(); ++i)
        if (!visit(own[i], own.subspan(i + 1), 0.0F, 1.0F)) return;
      const auto turn = [&](std::size_t b) { return members[b].direction - own[0].direction; };
      std::size_t b = a + own.size();
      for (; b < members.size() && turn(b) <= widest_ && turn(b) < round; b = end_of_direction(members, b))
        if (!visit_each(own, members, b, turn(b), 1, visit)) return;
      // The first and the last directions are neighbours, with the sides of the line exchanged.
      b = std::max(b, first_from(members, own[0].direction + round));
      for (; b < members.size(); b = end_of_direction(members, b))
        if (!visit_each(own, members, b, half_turn - turn(b), -1, visit)) return;
    }
  }

  template <class Visit>
  static bool visit_each(std::span<const Member> own, std::span<const Member> members, std::size_t begin, float turn,
                         float side, const Visit& visit) {
    const auto others = members.subspan(begin, end_of_direction(members, begin) - begin);
    return std::all_of(own.begin(), own.end(), [&](const Member& member) { return visit(member, others, turn, side); });
  }

  [[nodiscard]] std::span<const Member> near(const Member& a, std::span<const Member> others, float turn,
                                             float side) const;
  void fill(const Progress& progress);
  static void sort_cell(std::span<Member> members);
  [[nodiscard]] bool has_many_pairs(std::size_t cell) const;
  void find_crowds(const Progress& progress);
  void plant_trees(const Progress& progress);

  static constexpr float half_turn = 2;  ///< in the measure of directions

  const std::vector<Piece>& pieces_;
  double tolerance_;
  float widest_;  ///< difference in direction
  CellGrid grid_{};
  double radius_ = 0;  ///< of the circle around a cell
  Groups<Member> members_;
  std::vector<char> crowded_;   ///< by cell; empty if none is
  std::vector<char> in_crowd_;  ///< by piece
  std::vector<int> tree_of_;    ///< by cell, or -1
  std::vector<PieceTree> trees_;
};

}  // namespace epura
