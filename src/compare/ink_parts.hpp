// SPDX-License-Identifier: Apache-2.0
// The visible parts of a drawing's lines, and which of them another drawing has.
#pragma once

#include <vector>

#include "compare/picture.hpp"

namespace epura::compare {

/// A straight part of a line, with the number of its look in a table of both drawings. The others are numbers of the
/// picture that it comes from.
struct InkPart {
  Vec2 from, to;
  int look;
  int own_look, view, origin;
};

/// The line styles of two drawings, each once.
struct CommonLooks {
  std::vector<PictureLook> looks;        ///< what is seen where several lie on one another comes first
  std::vector<int> of_before, of_after;  ///< by look of the picture
};

CommonLooks common_looks(const Picture& before, const Picture& after);

/// The lines of a picture, or the borders of its areas, each place once and in an order that depends on places alone.
/// `looks`: the number in the table for each line style of the picture. Pieces up to 0.002 mm are left out.
std::vector<InkPart> seen_parts(const Picture& picture, const CommonLooks& table, const std::vector<int>& looks,
                                bool filled);

struct DividedInk {
  std::vector<InkPart> met, rest;
};

/// The parts that lie within `tolerance` mm of one of `others`, whatever its look, and those that do not. Remainders up
/// to the tolerance are left out, as are whole parts up to 0.004 mm.
DividedInk divide(const std::vector<InkPart>& parts, const std::vector<InkPart>& others, double tolerance);

double length_of(const InkPart& part);

}  // namespace epura::compare
