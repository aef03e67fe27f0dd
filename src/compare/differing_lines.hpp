// SPDX-License-Identifier: Apache-2.0
// Differing parts of lines -> lines as people see them.
#pragma once

#include <string>
#include <vector>

#include "compare/ink_parts.hpp"

namespace epura::compare {

/// A part that is not the same, with the number of the look in the other picture that is in its place; -1 for none.
struct DifferingPart {
  InkPart part;
  int other = -1;
};

/// Parts of one style and view that continue each other without a corner.
struct DifferingLine {
  std::vector<InkPart> parts;
  int look, other;
  Vec2 from, to;     ///< its ends; the same point twice of a closed line
  Vec2 min, max;     ///< its box
  double length;     ///< mm
  std::string name;  ///< of its look
  std::string view;
  std::string origin;  ///< edges that are drawn, each once, sorted, with spaces
};

/// In an order that depends on places alone. `picture` is that of the parts. Ends within `reach` mm meet.
std::vector<DifferingLine> join_lines(std::vector<DifferingPart> parts, const Picture& picture, double reach);

/// A line of `before` and one of `after` that is the same in another place.
struct MovedLine {
  int before, after;
  double distance;  ///< mm
};

/// Pairs: the only lines of an edge in either drawing; then lines of one look, length and form, not more than 5 mm
/// apart. Each line is in one pair at most.
std::vector<MovedLine> find_moved(const std::vector<DifferingLine>& before, const std::vector<DifferingLine>& after,
                                  double tolerance);

}  // namespace epura::compare
