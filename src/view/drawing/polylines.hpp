// SPDX-License-Identifier: Apache-2.0
// Pieces of the same strength, joined end to end.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/continuations.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Every piece with a strength is in exactly one polyline. Where it begins depends on its places on the page alone.
class Polylines {
 public:
  /// `strength` by piece: stronger pieces are drawn instead of weaker ones; if it is negative, the piece is not ink.
  /// Ends up to `touching` mm apart meet. Throws OutOfTime.
  Polylines(const std::vector<Piece>& pieces, const std::vector<signed char>& strength, const Progress& progress,
            double touching = 0);

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  /// The ends at which its pieces are entered, in order.
  [[nodiscard]] std::span<const End> operator[](std::size_t line) const {
    return std::span(members_).subspan(lines_[line].first, lines_[line].count);
  }
  [[nodiscard]] bool is_closed(std::size_t line) const { return lines_[line].closed; }

  /// The strongest first, then the longest, then the one that begins first across the page.
  [[nodiscard]] std::vector<std::size_t> by_rank() const;

 private:
  struct Line {
    std::size_t first, count;
    bool closed;
    int strength;
    double length;
    double order;  ///< of its beginning on the page
  };

  std::vector<End> members_;
  std::vector<Line> lines_;
};

}  // namespace epura::drawing
