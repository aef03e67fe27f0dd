// SPDX-License-Identifier: Apache-2.0
// A part as its sheets show it, and what they say of its faces.
#pragma once

#include <span>
#include <vector>

#include "definition/account.hpp"
#include "sizes/drawn_part.hpp"
#include "sizes/face_statements.hpp"

namespace epura::sheet {

/// It refers to the notation.
struct SheetReading {
  DrawnPart drawn;
  definition::Directions directions;
  definition::Unknowns unknowns;  ///< of the faces above
  const Notation& notation;
  FaceStatements said;

  SheetReading(DrawnPart part, std::span<const DimensionsInView> views, const Notation& written);
  SheetReading(const SheetReading&) = delete;
  SheetReading& operator=(const SheetReading&) = delete;

  /// What rules say of the faces, as some values have changed them.
  [[nodiscard]] std::vector<definition::Statement> rules(const definition::RuleSet& applied,
                                                         const definition::Unknowns& changed) const;
  [[nodiscard]] definition::Account account(const definition::RuleSet& applied) const;
};

}  // namespace epura::sheet
