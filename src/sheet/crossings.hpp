// Where lines of a drawing meet each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"

namespace epura {

/// Looks for crossings among the lines of one drawing by means of a grid.
class Crossings {
 public:
  explicit Crossings(std::span<const Chain> chains);

  /// Distances along a chain from its first point, ascending, at which another chain that is no tangent edge crosses
  /// it, touches it or ends on it. Points nearer than `apart` mm count once.
  [[nodiscard]] std::vector<double> along(std::size_t chain, double apart) const;

  /// Whether a visible line that is no tangent edge runs through a point.
  [[nodiscard]] bool has_outline_at(const Vec2& point) const;

 private:
  struct Line {
    Vec2 from, to;
    std::size_t chain;
  };
  [[nodiscard]] int cell_of(double at, double least, int count) const;
  template <class Visit>
  void visit_cells(const Vec2& from, const Vec2& to, const Visit& visit) const;

  std::span<const Chain> chains_;
  Vec2 least_{0, 0};
  double side_ = 1;  ///< of a cell
  int columns_ = 1, rows_ = 1;
  std::vector<Line> lines_;
  std::vector<int> first_;  ///< by cell, into lines_of_cells_
  std::vector<int> lines_of_cells_;
};

}  // namespace epura
