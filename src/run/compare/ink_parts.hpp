// SPDX-License-Identifier: Apache-2.0
// The visible parts of a drawing's lines, and which of them another drawing has, too.
#pragma once

#include <vector>

#include "compare/picture.hpp"

namespace epura::compare {

/// A straight part of a line. `look` is a number in the common table of both drawings; the other numbers are those of
/// the part's own picture.
struct InkPart {
  Vec2 from, to;
  int look;
  int own_look, view, origin;
};

/// The line styles of two drawings, each once.
struct CommonLooks {
  std::vector<PictureLook> looks;        ///< of coincident lines, the one that is seen comes first
  std::vector<int> of_before, of_after;  ///< by look of the picture
};

CommonLooks common_looks(const Picture& before, const Picture& after);

/// The lines of a picture, or the borders of its areas, each position once and in an order that depends on positions
/// alone. `looks` gives the number in the table for each line style of the picture. Pieces of up to 0.002 mm are
/// omitted.
std::vector<InkPart> seen_parts(const Picture& picture, const CommonLooks& table, const std::vector<int>& looks,
                                bool filled);

struct DividedInk {
  std::vector<InkPart> met, rest;
};

/// The parts within `tolerance` mm of one of `others`, whatever its look, and those that are not. Remainders up to the
/// tolerance are omitted, and so are whole parts up to 0.004 mm.
DividedInk divide(const std::vector<InkPart>& parts, const std::vector<InkPart>& others, double tolerance);

double length_of(const InkPart& part);

}  // namespace epura::compare
