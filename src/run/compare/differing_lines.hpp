// SPDX-License-Identifier: Apache-2.0
// Joins differing parts of lines to lines as people see them.
#pragma once

#include <string>
#include <vector>

#include "compare/ink_parts.hpp"

namespace epura::compare {

/// A differing part, with the number of the look that the other picture has at the same position; -1 for none.
struct DifferingPart {
  InkPart part;
  int other = -1;
};

/// Parts of one style and view that continue each other without a corner.
struct DifferingLine {
  std::vector<InkPart> parts;
  int look, other;
  Vec2 from, to;     ///< its ends; the same point twice if it is closed
  Vec2 min, max;     ///< its box
  Vec2 centre;       ///< of gravity
  double length;     ///< mm
  std::string name;  ///< of its look
  std::string view;
  std::string origin;  ///< edges drawn, each once, sorted, separated by spaces
};

/// The order depends on positions alone. `picture` is the picture of the parts. Ends within `reach` mm of each other
/// meet.
std::vector<DifferingLine> join_lines(std::vector<DifferingPart> parts, const Picture& picture, double reach);

/// A line of `before` and a line of `after` that is the same at another position.
struct MovedLine {
  int before, after;
  double distance;  ///< mm
};

/// Pairs the only lines of an edge in either drawing; then lines of one look, length and shape, at most 5 mm apart.
/// Each line is in at most one pair.
std::vector<MovedLine> find_moved(const std::vector<DifferingLine>& before, const std::vector<DifferingLine>& after,
                                  double tolerance);

}  // namespace epura::compare
