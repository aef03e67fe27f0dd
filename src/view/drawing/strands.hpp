// SPDX-License-Identifier: Apache-2.0
// Finds the pieces of a drawing that run beside one another.
//
// Where one piece covers another, the overlap begins and ends at an end of one of them. So a part of the paper matters
// only if it contains ends. It is divided while that saves work, which is measured as the number of ends times the
// number of pieces. Pieces are grouped by direction, and the paper is divided separately for each direction, along and
// across. The cells become long and thin, and lines that run beside one another seldom leave them. Without this, random
// lines would have a number of near pairs that grows with the square of their number.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// The part of a piece that runs through a cell of the paper. x points roughly along the pieces in the cell.
struct Strand {
  Vec2 from, to;  ///< from.x <= to.x
  int piece;
  /// Whether `from` and `to` are relevant ends of the piece: if all pieces go along x, an overlap begins at a `from`.
  bool begins, ends;
  bool is_guest;  ///< belongs to the next class of directions, which searches pairs of such pieces
};

using Strands = std::vector<Strand>;

/// Returns the strands of two cells that replace one; nothing if that would save too little. Strands within twice the
/// tolerance of both cells are in both. `go_along` is that of their class.
std::optional<std::pair<Strands, Strands>> divide(const Strands& strands, double tolerance, bool go_along);

/// Pieces grouped by direction.
class DirectionClasses {
 public:
  /// `spread` is the greatest difference in direction, in radians, between pieces that cover one another. Throws
  /// OutOfTime.
  DirectionClasses(const std::vector<Piece>& pieces, double spread, const Progress& progress);

  [[nodiscard]] std::size_t size() const { return classes_; }
  /// Returns the pieces of a class and its guests, undivided, with x along the longest piece of the class.
  [[nodiscard]] Strands strands(std::size_t number) const;
  /// Whether all pieces of a class extend along its x by more than half of their length.
  [[nodiscard]] bool go_along() const { return classes_ > 6; }

 private:
  // A class consists of this many turns, each as wide as the spread. The pieces in the first turn of the next class are
  // its guests.
  static constexpr std::size_t turns = 2;

  const std::vector<Piece>& pieces_;
  std::size_t classes_;
  std::vector<std::size_t> first_;  ///< by turn, into members_
  std::vector<int> members_;
};

}  // namespace epura::drawing
