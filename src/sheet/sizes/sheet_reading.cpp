// SPDX-License-Identifier: Apache-2.0
#include "sizes/sheet_reading.hpp"

#include <utility>

#include "base/error.hpp"

namespace epura::sheet {

SheetReading::SheetReading(DrawnPart part, std::span<const DimensionsInView> views, const Notation& written)
    : drawn(std::move(part)),
      directions(definition::find_directions(drawn.part.faces)),
      unknowns(drawn.part, directions),
      notation(written),
      said(state_dimensions(views, drawn, directions, unknowns, notation)) {
  check(said.of.size() == said.statements.size(), "each statement is that of a dimension");
}

std::vector<definition::Statement> SheetReading::rules(const definition::RuleSet& applied,
                                                       const definition::Unknowns& changed) const {
  return definition::state_rules(drawn.part, directions, changed, drawn.marks, applied);
}

definition::Account SheetReading::account(const definition::RuleSet& applied) const {
  return definition::take_account(drawn.part, unknowns, rules(applied, unknowns),
                                  definition::with_counts(said.statements, applied));
}

}  // namespace epura::sheet
