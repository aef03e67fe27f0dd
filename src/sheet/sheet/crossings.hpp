// SPDX-License-Identifier: Apache-2.0
// Points where lines of a drawing meet.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/groups.hpp"
#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "search/line_cells.hpp"

namespace epura::sheet {

/// Finds crossings among the lines of one drawing by means of a grid.
class Crossings {
 public:
  /// Finds crossings of the chains `asked` (ascending). Other chains have no crossings. Throws OutOfTime.
  Crossings(std::span<const drawing::Chain> chains, std::vector<std::size_t> asked, const Progress& progress = {});

  /// Distances along a chain from its first point, ascending, at which another chain that is not a tangent edge crosses
  /// it, touches it or ends on it. Points closer than `apart` mm count once.
  [[nodiscard]] std::vector<double> along(std::size_t chain, double apart) const;

  /// Whether a visible line that is not a tangent edge passes through a point of a requested chain.
  [[nodiscard]] bool has_outline_at(const Vec2& point) const;

 private:
  struct Line {
    Vec2 from, to;
    std::size_t chain;
  };
  [[nodiscard]] std::vector<char> wanted_cells(const Progress& progress) const;
  void fill(const std::vector<char>& wanted, const Progress& progress);

  std::span<const drawing::Chain> chains_;
  std::vector<std::size_t> asked_;
  search::CellGrid grid_{};
  std::vector<Line> lines_;
  Groups<int> lines_of_cells_;  ///< numbers of lines_
};

}  // namespace epura::sheet
