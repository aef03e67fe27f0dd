// SPDX-License-Identifier: Apache-2.0
// The visible lines of a view on paper, before lines beside others are left out.
#pragma once

#include <cstddef>
#include <vector>

#include "accuracy/judged_view.hpp"
#include "search/bounds_tree.hpp"

namespace epura::accuracy {

/// A line from a vertex of the view.
struct LineFrom {
  int vertex;
  Vec2 along;  ///< on paper, mm
};

class SeenInk : JudgedView {
 public:
  /// The view must outlive it.
  explicit SeenInk(const ViewToJudge& judged);

  /// Returns a bound of how far a line, or what lies as far to the other side of the vertex, is from lines that have no
  /// end in this vertex: at least `known`, at most the line's length, otherwise at most a third too much.
  [[nodiscard]] double farthest_from_others(const LineFrom& line, double known) const;

 private:
  /// A visible part of an edge, where it is drawn.
  struct Part {
    std::size_t edge;
    Vec2 from, to;
  };

  std::vector<Part> parts_;
  search::BoundsTree<2> tree_;

  [[nodiscard]] double to_others(const Vec2& place, const LineFrom& line) const;
};

}  // namespace epura::accuracy
