// SPDX-License-Identifier: Apache-2.0
#include "datum_references.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "measures.hpp"

namespace occt {

namespace {

// The attributes that datum references have beyond other shape aspects.
constexpr std::size_t base_place = 4, modifiers_place = 5;

// References of AP203 and AP214 are records of their own.
const Record* old_reference(const Statement& statement) {
  const Record* modified = record_of(statement, "REFERENCED_MODIFIED_DATUM");
  return modified != nullptr ? modified : record_of(statement, "DATUM_REFERENCE");
}

// Modifiers without and with a value.
std::string modifiers_of(const StepGraph& graph, const Record& reference) {
  const std::string_view list = argument_of(reference, modifiers_place);
  std::string modifiers;
  for (const std::string& word : enumerations_in(list)) append(modifiers, word);
  for (const EntityNumber number : references_in(list)) {
    const Statement* statement = graph.find(number);
    if (statement == nullptr) continue;
    for (const Record& record : statement->records) {
      const std::vector<EntityNumber> values = references_in(record.arguments);
      const double length = values.empty() ? std::nan("") : measure_of(graph, values.front()).value;
      const std::string text = std::isnan(length) ? "?" : printed_length(length) + " mm";
      for (const std::string& word : enumerations_in(record.arguments))
        append(modifiers, values.empty() ? word : word + " " + text);
    }
  }
  return modifiers;
}

// A compartment of a frame, or an element of a common datum in it.
std::string text_of_reference(const StepGraph& graph, EntityNumber number, bool is_element) {
  const Statement* statement = graph.find(number);
  const Record* reference = statement == nullptr ? nullptr
                                                 : record_of(*statement, is_element ? "DATUM_REFERENCE_ELEMENT"
                                                                                    : "DATUM_REFERENCE_COMPARTMENT");
  if (reference == nullptr) return "?";
  const std::string_view base = argument_of(*reference, base_place);
  std::string text;
  if (const EntityNumber datum = reference_in(base))
    text = letter_of(graph, datum);
  else if (!is_element)
    for (const EntityNumber element : references_in(base)) append(text, text_of_reference(graph, element, true), "-");
  if (text.empty()) text = "?";
  const std::string modifiers = modifiers_of(graph, *reference);
  return modifiers.empty() ? text : text + " (" + modifiers + ")";
}

}  // namespace

std::string letter_of(const StepGraph& graph, EntityNumber datum) {
  const Statement* statement = graph.find(datum);
  const Record* record = statement == nullptr ? nullptr : record_of(*statement, "DATUM");
  const std::string letter = record == nullptr ? "" : unquoted(last_argument_of(*record));
  return letter.empty() ? "?" : letter;
}

std::string datum_references(const StepGraph& graph, std::string_view list) {
  std::string datums;
  std::vector<std::pair<double, std::string>> ranked;  // of AP203 and AP214, which state a precedence
  for (const EntityNumber number : references_in(list)) {
    const Statement* statement = graph.find(number);
    if (statement == nullptr) continue;
    if (const Record* system = record_of(*statement, "DATUM_SYSTEM")) {
      for (const EntityNumber compartment : references_in(argument_of(*system, 4)))
        append(datums, text_of_reference(graph, compartment, false), " | ");
    } else if (const Record* one = old_reference(*statement)) {
      std::string text = letter_of(graph, reference_in(argument_of(*one, 1)));
      if (const auto modifiers = enumerations_in(argument_of(*one, 2)); !modifiers.empty())
        text += " (" + modifiers.front() + ")";
      const double rank = number_in(argument_of(*one, 0));
      ranked.emplace_back(std::isnan(rank) ? 0 : rank, std::move(text));
    } else if (record_of(*statement, "DATUM") != nullptr) {
      append(datums, letter_of(graph, number), " | ");
    }
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [rank, text] : ranked) append(datums, text, " | ");
  return datums;
}

}  // namespace occt
