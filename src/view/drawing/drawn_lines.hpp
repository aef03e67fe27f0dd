// SPDX-License-Identifier: Apache-2.0
// Lines of a drawing as facets have them and as they are drawn, and where other lines end at them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/page_curve.hpp"
#include "search/lines_at.hpp"

namespace epura::drawing {

/// A straight line on facets, mm, and the curve of which the same part of the drawing is drawn.
struct DrawnLine {
  std::array<Vec2, 2> facets;
  PageCurve drawn;
  bool is_moved;  ///< it is drawn elsewhere
  bool visible;
  int chain;       ///< its number
  int curve = -1;  ///< its number in that chain; -1 for a straight line
};

/// The lines of all chains as they are drawn. `facets` are the points of each chain on facets, in their order.
std::vector<DrawnLine> drawn_lines(const std::vector<Chain>& chains, const std::vector<std::vector<Vec2>>& facets);

/// Lines by their places on facets.
class DrawnLines {
 public:
  /// Those at a place are within `near` of it; lines that come within `touching` of each other touch; mm.
  DrawnLines(std::vector<DrawnLine> all, double near, double touching);

  /// Where a line ends on paper that something hides from `end` on, which is on facets. What is drawn elsewhere hides
  /// before what is not. A straight line that is not drawn elsewhere itself ends where facets have it, unless such a
  /// line hides it.
  [[nodiscard]] std::optional<Vec2> end_in_edge(const DrawnLine& line, const Vec2& end) const;

  /// The same for a line that ends in a vertex, on lines that are drawn elsewhere: nothing if `drawn_end`, its end on
  /// paper, touches any line that it meets on facets.
  [[nodiscard]] std::optional<Vec2> end_at_vertex(const DrawnLine& line, const Vec2& end, const Vec2& drawn_end) const;

 private:
  /// Calls visit(number) for each line at a place, other than `line` itself, which ends there.
  template <class Visit>
  void visit_others_at(const Vec2& end, const DrawnLine& line, const Visit& visit) const;
  [[nodiscard]] bool is_at(const DrawnLine& one, const Vec2& place) const;
  [[nodiscard]] std::optional<Vec2> meeting(const DrawnLine& line, std::size_t number, const Vec2& end) const;

  std::vector<DrawnLine> all_;
  double near_, touching_;
  search::LinesAt at_;
};

}  // namespace epura::drawing
