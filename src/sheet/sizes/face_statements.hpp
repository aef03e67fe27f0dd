// SPDX-License-Identifier: Apache-2.0
// What dimensions say of the faces of a part.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "definition/statements.hpp"
#include "sheet/notation.hpp"
#include "sizes/dimension_names.hpp"
#include "sizes/drawn_part.hpp"

namespace epura::sheet {

struct FaceStatements {
  std::vector<definition::Statement> statements;
  std::vector<DimensionPlace> of;      ///< the dimension of each
  std::vector<DimensionPlace> unread;  ///< dimensions of which nobody can tell what they measure
};

/// Of auxiliary dimensions, which are in brackets, nothing. What a text says beside the measured value is a statement
/// in doubt where more than one thing at its place has the size: better one face too many is held than one too few.
FaceStatements state_dimensions(std::span<const DimensionsInView> views, const DrawnPart& drawn,
                                const definition::Directions& directions, const definition::Unknowns& unknowns,
                                const Notation& notation);

}  // namespace epura::sheet
