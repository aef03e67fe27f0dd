// SPDX-License-Identifier: Apache-2.0
#include "requirements.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "datum_references.hpp"
#include "measures.hpp"
#include "requirement_index.hpp"
#include "step_notes.hpp"
#include "step_textures.hpp"

namespace occt {

namespace {

constexpr std::string_view of_tolerance = "_TOLERANCE";

/// Aspects and items of all requirements together. A file of some kilobytes may relate each of many dimensions to many.
constexpr std::size_t max_items = 1'000'000;

// "PERPENDICULARITY" of "PERPENDICULARITY_TOLERANCE"; empty for records that say something else of a tolerance.
std::string_view characteristic_in(std::string_view keyword) {
  constexpr std::array<std::string_view, 15> characteristics{
      "ANGULARITY", "CIRCULAR_RUNOUT", "COAXIALITY",      "CONCENTRICITY",    "CYLINDRICITY",
      "FLATNESS",   "LINE_PROFILE",    "PARALLELISM",     "PERPENDICULARITY", "POSITION",
      "ROUNDNESS",  "STRAIGHTNESS",    "SURFACE_PROFILE", "SYMMETRY",         "TOTAL_RUNOUT"};
  if (keyword.size() <= of_tolerance.size()) return {};
  const std::string_view begin = keyword.substr(0, keyword.size() - of_tolerance.size());
  const bool is_one = keyword.substr(begin.size()) == of_tolerance &&
                      std::find(characteristics.begin(), characteristics.end(), begin) != characteristics.end();
  return is_one ? begin : std::string_view();
}

// Of an entity of several records, the one with the attributes that all dimensions have.
const Record* dimension_in(const Statement& statement) {
  for (const std::string_view whole : {"DIMENSIONAL_SIZE", "DIMENSIONAL_LOCATION"})
    if (const Record* record = record_of(statement, whole)) return record;
  const auto found = std::find_if(statement.records.begin(), statement.records.end(),
                                  [](const Record& record) { return is_dimension(record.keyword); });
  return found == statement.records.end() ? nullptr : &*found;
}

// Whether a document is called the standard of dimensions or tolerances, or has the name of one.
bool names_standard(const std::string& id, const std::string& words) {
  const bool is_of_drawings =
      words.find("dimension") != std::string::npos || words.find("toleranc") != std::string::npos;
  return id.starts_with("ASME ") || id.starts_with("ISO ") ||
         (is_of_drawings && words.find("standard") != std::string::npos);
}

// Documents are referred to in a role: "dimensioning standard".
std::string standard_in(const StepGraph& graph) {
  std::map<EntityNumber, std::string> ids, words;            // of documents
  std::map<EntityNumber, EntityNumber> references;           // documents
  std::vector<std::pair<EntityNumber, EntityNumber>> roles;  // and what has them
  for (const auto& [number, statement] : graph.statements())
    for (const Record& record : statement.records) {
      if (record.keyword == "DOCUMENT") {
        const std::string id = unquoted(argument_of(record, 0)), name = unquoted(argument_of(record, 1));
        ids[number] = id.empty() ? name : id;
        words[number] = lower_case(name + " " + unquoted(argument_of(record, 2)));
      } else if (record.keyword.ends_with("DOCUMENT_REFERENCE")) {
        references[number] = reference_in(argument_of(record, 0));
      } else if (record.keyword == "ROLE_ASSOCIATION") {
        roles.emplace_back(reference_in(argument_of(record, 0)), reference_in(argument_of(record, 1)));
      }
    }
  for (const auto& [role, reference] : roles)
    if (const Statement* statement = graph.find(role); statement != nullptr && references.count(reference) != 0)
      if (const Record* record = record_of(*statement, "OBJECT_ROLE"))
        words[references[reference]] +=
            " " + lower_case(unquoted(argument_of(*record, 0)) + " " + unquoted(argument_of(*record, 1)));
  std::string standards;
  for (const auto& [number, id] : ids)
    if (names_standard(id, words[number])) append(standards, id);
  return standards;
}

const char* lack_of(const Measure& measure, const char* otherwise) {
  return measure.has_unit ? otherwise : "the unit of a value";
}

class RequirementReader {
 public:
  explicit RequirementReader(std::string_view text)
      : graph_(text), index_(index_of(graph_)), length_unit_(length_unit_in(graph_)) {}

  StepRequirements read() {
    StepRequirements result;
    std::vector<Requirement>& found = result.all;
    for (const auto& [number, statement] : graph_.statements()) {
      Requirement requirement;
      requirement.id = "#" + std::to_string(number);
      requirement.length_unit = length_unit_;
      if (const Record* dimension = dimension_in(statement)) {
        read_dimension(number, *dimension, requirement);
      } else if (has_record(statement, is_tolerance)) {
        read_tolerance(number, statement, requirement);
      } else if (const Record* datum = record_of(statement, "DATUM")) {
        read_datum(number, *datum, requirement);
      } else if (has_record(statement, is_datum)) {
        read_target(number, statement, requirement);
      } else {
        continue;
      }
      take_identity(number, requirement);
      found.push_back(std::move(requirement));
    }
    result.read = std::move(read_);
    std::ranges::move(textures_in_step(graph_, index_, items_left_, result.read), std::back_inserter(found));
    Notes notes = notes_in_step(graph_, index_, items_left_);
    std::ranges::move(notes.all, std::back_inserter(found));
    result.pictures = std::move(notes.wordless);
    result.standard = standard_in(graph_);
    return result;
  }

 private:
  Measure measure(EntityNumber number) const {
    Measure measure = measure_of(graph_, number);
    qualify(measure, graph_, listed(index_.qualifiers, number));
    return measure;
  }

  // A UUID or an id that programs exchange says more than a name, which is often the type again.
  void take_identity(EntityNumber number, Requirement& requirement) const {
    for (const EntityNumber identity : listed(index_.identities, number))
      for (const Record& record : graph_.find(identity)->records)
        if (const std::string text = unquoted(argument_of(record, 0)); !text.empty()) requirement.name = text;
  }

  void add_items(EntityNumber aspect, Requirement& requirement) {
    const std::vector<EntityNumber> items = items_of(index_, aspect, items_left_);
    requirement.items.insert(requirement.items.end(), items.begin(), items.end());
    if (items_left_ == 0) append(requirement.missing, "further faces, which are too many");
  }

  // Dimensions.

  void read_dimension(EntityNumber number, const Record& record, Requirement& requirement) {
    requirement.kind = EPURA_DIMENSION;
    const bool is_size = record.keyword.find("SIZE") != std::string_view::npos;
    requirement.is_angle = record.keyword.find("ANGULAR") != std::string_view::npos;
    requirement.name = unquoted(argument_of(record, is_size ? 1 : 0));
    requirement.type = lower_case(requirement.name);
    if (requirement.type.empty()) requirement.type = words_of(record.keyword);
    add_items(reference_in(argument_of(record, is_size ? 0 : 2)), requirement);
    if (!is_size) add_items(reference_in(argument_of(record, 3)), requirement);
    for (const EntityNumber representation : listed(index_.representations, number))
      if (const Statement* statement = graph_.find(representation))
        if (const Record* items = record_of(*statement, "SHAPE_DIMENSION_REPRESENTATION"))
          read_values(references_in(argument_of(*items, 1)), requirement);
    for (const EntityNumber range : listed(index_.bounds, number)) read_bounds(range, requirement);
    if (std::isnan(requirement.value) && requirement.bounds != EPURA_LIMITS && requirement.missing.empty())
      append(requirement.missing, "a value");
    if (requirement.items.empty()) append(requirement.missing, "a face that it belongs to");
  }

  // Lists in lists come at the end. What a list holds twice, or itself, counts once.
  void read_values(std::vector<EntityNumber> items, Requirement& requirement) {
    std::set<EntityNumber> seen;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const EntityNumber item = items[i];
      const Statement* statement = graph_.find(item);
      if (statement == nullptr || !seen.insert(item).second) continue;
      if (const Record* list = record_of(*statement, "COMPOUND_REPRESENTATION_ITEM"))
        std::ranges::copy(references_in(list->arguments), std::back_inserter(items));
      else if (const Record* note = record_of(*statement, "DESCRIPTIVE_REPRESENTATION_ITEM"))
        append(requirement.modifiers, lower_case(unquoted(argument_of(*note, 1))));
      else
        take(measure(item), requirement);
    }
  }

  static void take(const Measure& measure, Requirement& requirement) {
    if (std::isnan(measure.value)) return append(requirement.missing, lack_of(measure, "an item of its values"));
    requirement.is_angle = measure.is_angle;
    requirement.unit = measure.unit;
    requirement.decimals = std::max(requirement.decimals, measure.decimals);
    const bool is_upper = measure.name.find("upper") != std::string::npos;
    if (is_upper || measure.name.find("lower") != std::string::npos) {
      (is_upper ? requirement.upper : requirement.lower) = measure.value;
      requirement.bounds = EPURA_LIMITS;
      return;
    }
    requirement.value = measure.value;
    if (measure.qualifier != "designed") append(requirement.modifiers, lower_case(measure.qualifier));
  }

  void read_bounds(EntityNumber number, Requirement& requirement) const {
    const Statement* statement = graph_.find(number);
    const Record* range = statement == nullptr ? nullptr : record_of(*statement, "TOLERANCE_VALUE");
    const Record* fit = statement == nullptr ? nullptr : record_of(*statement, "LIMITS_AND_FITS");
    if (fit != nullptr) {
      requirement.fit = unquoted(argument_of(*fit, 0)) + unquoted(argument_of(*fit, 2));
    } else if (range != nullptr) {
      const Measure lower = measure(reference_in(argument_of(*range, 0)));
      const Measure upper = measure(reference_in(argument_of(*range, 1)));
      if (std::isnan(lower.value) || std::isnan(upper.value))
        return append(requirement.missing, "the values of its deviations");
      requirement.lower = lower.value;
      requirement.upper = upper.value;
      requirement.bounds = EPURA_DEVIATIONS;
    } else {
      append(requirement.missing, "the range of its tolerance");
    }
  }

  // Tolerances.

  void read_tolerance(EntityNumber number, const Statement& statement, Requirement& requirement) {
    requirement.kind = EPURA_TOLERANCE;
    const Record* whole = record_of(statement, "GEOMETRIC_TOLERANCE");
    for (const Record& record : statement.records) {
      const std::string_view characteristic = characteristic_in(record.keyword);
      if (!characteristic.empty()) requirement.type = words_of(characteristic);
      if (whole == nullptr && !characteristic.empty()) {
        whole = &record;  // tolerances without further records have the datums at their end
        if (const std::string_view datums = argument_of(record, 4); !datums.empty()) read_datums(datums, requirement);
      }
      read_detail(record, requirement);
    }
    if (requirement.type.empty()) append(requirement.missing, "its characteristic");
    if (whole == nullptr) return append(requirement.missing, "everything but its name");
    requirement.name = unquoted(argument_of(*whole, 0));
    const Measure magnitude = measure(reference_in(argument_of(*whole, 2)));
    requirement.value = magnitude.value;
    requirement.unit = magnitude.unit;
    requirement.decimals = magnitude.decimals;
    requirement.is_angle = magnitude.is_angle;
    if (std::isnan(requirement.value)) append(requirement.missing, lack_of(magnitude, "a value"));
    find_place(reference_in(argument_of(*whole, 3)), requirement);
    for (const EntityNumber zone : listed(index_.zones, number)) read_zone(zone, requirement);
    for (const EntityNumber above : listed(index_.above, number))
      append(requirement.above, "#" + std::to_string(above));
  }

  void read_zone(EntityNumber number, Requirement& requirement) {
    const Record* zone = record_of(*graph_.find(number), "TOLERANCE_ZONE");
    const Statement* form = graph_.find(reference_in(last_argument_of(*zone)));
    if (const Record* name = form == nullptr ? nullptr : record_of(*form, "TOLERANCE_ZONE_FORM"))
      append(requirement.zone, lower_case(unquoted(argument_of(*name, 0))));
    for (const EntityNumber definition : listed(index_.definitions, number)) {
      read_.insert(definition);
      for (const Record& record : graph_.find(definition)->records) {
        if (record.keyword == "PROJECTED_ZONE_DEFINITION")
          add_length("projected", argument_of(record, 3), requirement);
        else
          append(requirement.missing, std::string(record.keyword));
      }
    }
  }

  // What a tolerance holds for: an aspect, what a dimension measures, or the whole part.
  void find_place(EntityNumber aspect, Requirement& requirement) {
    const Statement* statement = graph_.find(aspect);
    if (statement != nullptr && record_of(*statement, "PRODUCT_DEFINITION_SHAPE") != nullptr)
      return append(requirement.modifiers, "all over");
    if (statement != nullptr)
      for (const Record& record : statement->records) {
        if (record.keyword == "ALL_AROUND_SHAPE_ASPECT") append(requirement.modifiers, "all around");
        if (record.keyword == "BETWEEN_SHAPE_ASPECT") append(requirement.modifiers, "between");
      }
    if (const Record* size = statement == nullptr ? nullptr : record_of(*statement, "DIMENSIONAL_SIZE"))
      add_items(reference_in(argument_of(*size, 0)), requirement);
    add_items(aspect, requirement);
    if (requirement.items.empty()) append(requirement.missing, "a face that it belongs to");
  }

  void read_detail(const Record& record, Requirement& requirement) const {
    const std::string_view keyword = record.keyword;
    if (keyword == "GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE") {
      read_datums(record.arguments, requirement);
    } else if (keyword == "GEOMETRIC_TOLERANCE_WITH_MODIFIERS" || keyword == "MODIFIED_GEOMETRIC_TOLERANCE") {
      for (const std::string& modifier : enumerations_in(record.arguments)) append(requirement.modifiers, modifier);
    } else if (keyword == "GEOMETRIC_TOLERANCE_WITH_MAXIMUM_TOLERANCE") {
      add_length("maximum", argument_of(record, 0), requirement);
    } else if (keyword == "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE") {
      add_length("unequally disposed", argument_of(record, 0), requirement);
    } else if (keyword == "GEOMETRIC_TOLERANCE_WITH_DEFINED_UNIT") {
      add_length("per unit of", argument_of(record, 0), requirement);
    } else if (keyword != "GEOMETRIC_TOLERANCE" && characteristic_in(keyword).empty()) {
      append(requirement.missing, std::string(keyword));
    }
  }

  void add_length(const std::string& word, std::string_view reference, Requirement& requirement) const {
    const Measure length = measure(reference_in(reference));
    if (std::isnan(length.value)) return append(requirement.missing, "the length of '" + word + "'");
    append(requirement.modifiers, word + " " + printed_length(length.value) + " mm");
  }

  // Datums.

  void read_datums(std::string_view list, Requirement& requirement) const {
    requirement.datums = datum_references(graph_, list);
    if (requirement.datums.empty() || requirement.datums.find('?') != std::string::npos)
      append(requirement.missing, "a datum that it refers to");
  }

  void read_datum(EntityNumber number, const Record& record, Requirement& requirement) {
    requirement.kind = EPURA_DATUM;
    requirement.type = "datum";
    requirement.name = unquoted(argument_of(record, 0));
    requirement.datums = letter_of(graph_, number);
    add_items(number, requirement);
    bool has_targets = false;
    for (const EntityNumber feature : listed(index_.features, number)) {
      const Statement* statement = graph_.find(feature);
      const bool is_target = statement != nullptr && has_record(*statement, is_datum);
      has_targets = has_targets || is_target;
      add_items(feature, requirement);
      if (is_target) add_area(feature, requirement, false);
    }
    if (has_targets) append(requirement.modifiers, "targets");
    if (requirement.items.empty() && !has_targets) append(requirement.missing, "a face that it belongs to");
  }

  static void take_size(const Measure& length, Requirement& requirement) {
    append(requirement.modifiers, length.name + " " + printed_length(length.value) + " mm");
    requirement.unit = length.unit;
    const bool is_diameter = length.name == "target diameter";
    if (is_diameter || length.name == "target length") requirement.target_length = length.value;
    if (is_diameter || length.name == "target width") requirement.target_width = length.value;
  }

  // The place of a target, as an item, and its size, also in words, if that is wanted.
  void add_area(EntityNumber target, Requirement& requirement, bool with_size) const {
    for (const EntityNumber property : listed(index_.properties, target))
      for (const EntityNumber number : listed(index_.representations, property)) {
        const Statement* statement = graph_.find(number);
        const Record* area =
            statement == nullptr ? nullptr : record_of(*statement, "SHAPE_REPRESENTATION_WITH_PARAMETERS");
        if (area == nullptr) continue;
        requirement.length_unit = length_unit_of(graph_, reference_in(argument_of(*area, 2)));
        for (const EntityNumber item : references_in(argument_of(*area, 1))) {
          const Measure length = measure(item);
          if (std::isnan(length.value))
            requirement.items.push_back(item);
          else if (with_size)
            take_size(length, requirement);
        }
      }
  }

  void read_target(EntityNumber number, const Statement& statement, Requirement& requirement) {
    const auto record = std::find_if(statement.records.begin(), statement.records.end(),
                                     [](const Record& one) { return is_datum(one.keyword); });
    requirement.kind = EPURA_DATUM;
    requirement.type = "datum target";
    requirement.name = unquoted(argument_of(*record, 0));
    requirement.zone = lower_case(unquoted(argument_of(*record, 1)));
    for (const EntityNumber datum : listed(index_.datums, number))
      requirement.datums = letter_of(graph_, datum) + unquoted(last_argument_of(*record));
    add_items(number, requirement);
    if (requirement.datums.empty()) append(requirement.missing, "the datum that it is a target of");
    add_area(number, requirement, true);
    if (requirement.items.empty()) append(requirement.missing, "the place of its area");
  }

  const StepGraph graph_;
  const RequirementIndex index_;
  const double length_unit_;
  std::size_t items_left_ = max_items;
  std::set<EntityNumber> read_{};  ///< definitions of zones
};

}  // namespace

bool is_dimension(std::string_view keyword) {
  constexpr std::array<std::string_view, 8> kinds{"DIMENSIONAL_SIZE",
                                                  "DIMENSIONAL_SIZE_WITH_PATH",
                                                  "DIMENSIONAL_LOCATION",
                                                  "DIMENSIONAL_LOCATION_WITH_PATH",
                                                  "ANGULAR_SIZE",
                                                  "ANGULAR_LOCATION",
                                                  "DIRECTED_DIMENSIONAL_LOCATION",
                                                  "DIMENSIONAL_SIZE_WITH_DATUM_FEATURE"};
  return std::find(kinds.begin(), kinds.end(), keyword) != kinds.end();
}

// Tolerances of AP242 have a record of this kind, alone or beside one that says which.
bool is_tolerance(std::string_view keyword) {
  return keyword == "GEOMETRIC_TOLERANCE" || !characteristic_in(keyword).empty();
}

bool is_datum(std::string_view keyword) {
  return keyword == "DATUM" || keyword == "PLACED_DATUM_TARGET_FEATURE" || keyword == "DATUM_TARGET";
}

StepRequirements requirements_in_step(std::string_view text) { return RequirementReader(text).read(); }

}  // namespace occt
