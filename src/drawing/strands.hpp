// SPDX-License-Identifier: Apache-2.0
// Which pieces of a drawing run beside one another.
//
// Where one piece covers another, the overlap begins and ends at an end of one of them. So a part of the paper matters
// only where ends lie in it, and is divided as long as that saves work, whose measure is the number of ends times that
// of the pieces. Pieces are taken by direction, and each direction is divided for itself, along and across: its cells
// grow long and thin, which lines that run beside one another seldom leave. Without that, lines at random would have as
// many near pairs as the square of their number.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// The part of a piece that runs through a cell of the paper. x goes about along the direction of those in the cell.
struct Strand {
  Vec2 from, to;  ///< from.x <= to.x
  int piece;
  /// Whether `from` and `to` are ends of the piece that count: where all go along x, an overlap begins with a `from`.
  bool begins, ends;
  bool is_guest;  ///< of the next class of directions, where pairs of such pieces are found
};

using Strands = std::vector<Strand>;

/// The strands of two cells instead of one; nothing where that would save too little. What lies within twice the
/// tolerance of both is in both. `go_along`: that of their class.
std::optional<std::pair<Strands, Strands>> divide(const Strands& strands, double tolerance, bool go_along);

/// Pieces by direction.
class DirectionClasses {
 public:
  /// `spread` is by how much pieces may differ in direction that cover one another, radians. Throws OutOfTime.
  DirectionClasses(const std::vector<Piece>& pieces, double spread, const Progress& progress);

  [[nodiscard]] std::size_t size() const { return classes_; }
  /// Those of a class and of its guests, whole, with x along the longest piece of the class.
  [[nodiscard]] Strands strands(std::size_t number) const;
  /// Whether pieces of a class all go with its x, by more than half of their length.
  [[nodiscard]] bool go_along() const { return classes_ > 6; }

 private:
  // A class is so many turns by the spread. The first turn of the next class is its guest.
  static constexpr std::size_t turns = 2;

  const std::vector<Piece>& pieces_;
  std::size_t classes_;
  std::vector<std::size_t> first_;  ///< by turn, into members_
  std::vector<int> members_;
};

}  // namespace epura::drawing
