// SPDX-License-Identifier: Apache-2.0
#include "requirement_index.hpp"

#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace occt {

namespace {

/// An entity that joins others: which of its arguments is the one, and which the others. Numbers below 0 count from the
/// end, since a record of several lacks what it inherits.
struct Join {
  std::string_view keyword;
  int from, to;
  References RequirementIndex::*table;
};

constexpr int itself = 1000;  // no argument: the entity

constexpr std::array<Join, 23> joins{
    {{"GEOMETRIC_ITEM_SPECIFIC_USAGE", 2, 4, &RequirementIndex::items},
     {"ITEM_IDENTIFIED_REPRESENTATION_USAGE", 2, 4, &RequirementIndex::items},
     {"SHAPE_ASPECT_RELATIONSHIP", 2, 3, &RequirementIndex::parts},
     {"SHAPE_ASPECT_DERIVING_RELATIONSHIP", 2, 3, &RequirementIndex::parts},
     {"FEATURE_FOR_DATUM_TARGET_RELATIONSHIP", 2, 3, &RequirementIndex::parts},
     {"DIMENSIONAL_CHARACTERISTIC_REPRESENTATION", 0, 1, &RequirementIndex::representations},
     {"SHAPE_DEFINITION_REPRESENTATION", 0, 1, &RequirementIndex::representations},
     {"PROPERTY_DEFINITION_REPRESENTATION", 0, 1, &RequirementIndex::representations},
     {"PLUS_MINUS_TOLERANCE", 1, 0, &RequirementIndex::bounds},
     {"TOLERANCE_ZONE", -2, itself, &RequirementIndex::zones},
     {"PROJECTED_ZONE_DEFINITION", 0, itself, &RequirementIndex::definitions},
     {"PROJECTED_ZONE_DEFINITION_WITH_OFFSET", 0, itself, &RequirementIndex::definitions},
     {"NON_UNIFORM_ZONE_DEFINITION", 0, itself, &RequirementIndex::definitions},
     {"RUNOUT_ZONE_DEFINITION", 0, itself, &RequirementIndex::definitions},
     {"PROPERTY_DEFINITION", 2, itself, &RequirementIndex::properties},
     {"PROPERTY_DEFINITION_RELATIONSHIP", 2, 3, &RequirementIndex::property_parts},
     {"MEASURE_QUALIFICATION", 2, 3, &RequirementIndex::qualifiers},
     {"ID_ATTRIBUTE", 1, itself, &RequirementIndex::identities},
     {"UUID_ATTRIBUTE", 1, itself, &RequirementIndex::identities},
     {"V4_UUID_ATTRIBUTE", 1, itself, &RequirementIndex::identities},
     {"V5_UUID_ATTRIBUTE", 1, itself, &RequirementIndex::identities},
     {"DRAUGHTING_MODEL_ITEM_ASSOCIATION", 4, 2, &RequirementIndex::shown},
     {"DRAUGHTING_MODEL_ITEM_ASSOCIATION_WITH_PLACEHOLDER", 4, 2, &RequirementIndex::shown}}};

std::vector<EntityNumber> joined(EntityNumber number, const Record& record, int place) {
  if (place == itself) return {number};
  const std::vector<std::string_view> arguments = separated(record.arguments);
  const std::size_t at = static_cast<std::size_t>(place) + (place < 0 ? arguments.size() : 0);
  return at < arguments.size() ? references_in(arguments[at]) : std::vector<EntityNumber>();
}

void add(RequirementIndex& index, const Join& join, EntityNumber number, const Record& record) {
  const std::vector<EntityNumber> others = joined(number, record, join.to);
  for (const EntityNumber one : joined(number, record, join.from)) {
    std::vector<EntityNumber>& known = (index.*join.table)[one];
    known.insert(known.end(), others.begin(), others.end());
  }
}

// Frames of a composite tolerance stand one below the other.
void add_composite(RequirementIndex& index, const Record& record) {
  if (unquoted(argument_of(record, 0)).find("composite") == std::string::npos) return;
  const EntityNumber upper = reference_in(argument_of(record, 2)), lower = reference_in(argument_of(record, 3));
  if (upper != 0 && lower != 0) index.above[lower].push_back(upper);
}

bool is_datum_itself(const StepGraph& graph, EntityNumber number) {
  const Statement* statement = graph.find(number);
  return statement != nullptr && record_of(*statement, "DATUM") != nullptr;
}

// Programs relate features to their datums in either direction.
void separate_datums(RequirementIndex& index, const StepGraph& graph) {
  References parts;
  for (const auto& [whole, some] : index.parts) {
    for (const EntityNumber part : some) {
      if (is_datum_itself(graph, part))
        index.features[part].push_back(whole);
      else if (is_datum_itself(graph, whole))
        index.features[whole].push_back(part);
      else
        parts[whole].push_back(part);
    }
  }
  index.parts = std::move(parts);
  for (const auto& [datum, features] : index.features)
    for (const EntityNumber feature : features) index.datums[feature].push_back(datum);
}

}  // namespace

RequirementIndex index_of(const StepGraph& graph) {
  RequirementIndex index;
  for (const auto& [number, statement] : graph.statements()) {
    for (const Record& record : statement.records) {
      for (const Join& join : joins)
        if (record.keyword == join.keyword) add(index, join, number, record);
      if (record.keyword == "GEOMETRIC_TOLERANCE_RELATIONSHIP") add_composite(index, record);
    }
  }
  separate_datums(index, graph);
  return index;
}

const std::vector<EntityNumber>& listed(const References& table, EntityNumber number) {
  static const std::vector<EntityNumber> none;
  const auto found = table.find(number);
  return found == table.end() ? none : found->second;
}

std::vector<EntityNumber> items_of(const RequirementIndex& index, EntityNumber aspect, std::size_t& left) {
  std::vector<EntityNumber> found, open{aspect};
  std::set<EntityNumber> seen{aspect}, seen_items;
  while (!open.empty() && left > 0) {
    const EntityNumber at = open.back();
    open.pop_back();
    --left;
    for (const EntityNumber item : listed(index.items, at)) {
      if (left == 0 || !seen_items.insert(item).second) continue;
      found.push_back(item);
      --left;
    }
    const std::vector<EntityNumber>& parts = listed(index.parts, at);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
      if (seen.insert(*part).second) open.push_back(*part);
  }
  return found;
}

}  // namespace occt
