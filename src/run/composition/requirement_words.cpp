// SPDX-License-Identifier: Apache-2.0
#include "composition/requirement_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/text.hpp"
#include "scene/choices.hpp"

namespace epura::pipeline {

namespace {

using importer::ModelRequirement;
using importer::RequirementBounds;
using importer::RequirementKind;

constexpr std::string_view behind_lengths = " mm";  // among the words of a file
constexpr int max_digits = 9;  // beyond them, values differ from what the file writes only by their conversion

bool is_in_inches(const ModelRequirement& one) { return one.unit == scene::millimetres(Unit::in); }

bool has_own_unit(const ModelRequirement& one) {
  return one.is_angle ? one.unit == 1 : one.unit == 1 || is_in_inches(one);
}

std::string unit_of(const ModelRequirement& one) { return one.is_angle ? "°" : is_in_inches(one) ? " in" : " mm"; }

std::string number_of(const ModelRequirement& one, double value) {
  return format_rounded(value / written_unit(one), max_digits);
}

std::string value_of(const ModelRequirement& one) {
  return one.decimals >= 0 && has_own_unit(one) ? format_with_zeros(one.value / one.unit, one.decimals)
                                                : number_of(one, one.value);
}

std::string with_sign(const ModelRequirement& one, double value) {
  return (value < 0 ? "" : "+") + number_of(one, value);
}

std::string bounds_of(const ModelRequirement& one) {
  if (one.bounds == RequirementBounds::none) return "";
  if (one.bounds == RequirementBounds::limits)
    return " from " + number_of(one, one.lower) + " to " + number_of(one, one.upper);
  if (one.upper >= 0 && one.lower == -one.upper) return " ±" + number_of(one, one.upper);
  return " " + with_sign(one, one.lower) + "/" + with_sign(one, one.upper);
}

// Lengths among words, "target diameter 6.35 mm", in inches where the file has these.
std::string in_unit_of(const ModelRequirement& one, std::string words) {
  if (!is_in_inches(one)) return words;
  for (std::size_t end = words.find(behind_lengths); end != std::string::npos;
       end = words.find(behind_lengths, end + 1)) {
    const std::size_t begin = end == 0 ? 0 : words.find_last_of(" (", end - 1) + 1;
    const auto length = parse_number(std::string_view(words).substr(begin, end - begin));
    if (!length) continue;
    const std::string inches = number_of(one, *length) + " in";
    words.replace(begin, end + behind_lengths.size() - begin, inches);
  }
  return words;
}

}  // namespace

std::optional<double> length_in(std::string_view word, std::string_view before) {
  if (!word.starts_with(before) || !word.ends_with(behind_lengths)) return std::nullopt;
  word.remove_prefix(before.size());
  return word.size() < behind_lengths.size() ? std::nullopt
                                             : parse_number(word.substr(0, word.size() - behind_lengths.size()));
}

double written_unit(const ModelRequirement& one) { return has_own_unit(one) ? one.unit : 1; }

int needed_decimals(double written) {
  const std::string text = format_rounded(written, max_digits);
  const std::size_t point = text.find('.');
  return point == std::string::npos || text.find('e') != std::string::npos ? 0
                                                                           : static_cast<int>(text.size() - point - 1);
}

std::vector<std::string> items_of(std::string_view text, std::string_view separator) {
  std::vector<std::string> items;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    items.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + separator.size(), text.size()));
  }
  return items;
}

std::string requirement_sentence(const ModelRequirement& one) {
  std::string text(one.type.empty() ? importer::requirement_kind_names[static_cast<std::size_t>(one.kind)] : one.type);
  if (one.kind == RequirementKind::note) return text + " '" + one.text + "'";
  if (one.kind == RequirementKind::surface_texture)
    return text + (one.text.empty() ? "" : " " + one.text) + (one.modifiers.empty() ? "" : ", " + one.modifiers);
  if (one.kind == RequirementKind::datum) text += " " + one.datums;
  if (std::isfinite(one.value)) text += " " + value_of(one);
  text += one.fit.empty() ? "" : " " + one.fit;
  text += bounds_of(one);
  if (std::isfinite(one.value) || one.bounds == RequirementBounds::limits) text += unit_of(one);
  if (one.kind == RequirementKind::tolerance && !one.datums.empty()) text += " to " + in_unit_of(one, one.datums);
  if (!one.zone.empty()) text += ", " + one.zone;
  if (!one.modifiers.empty()) text += ", " + in_unit_of(one, one.modifiers);
  if (!one.above.empty()) text += ", below " + one.above;
  return text;
}

std::vector<int> characteristic_numbers(const std::vector<ModelRequirement>& requirements) {
  std::vector<int> numbers;
  int last = 0;
  for (const ModelRequirement& one : requirements) {
    const std::vector<std::string> modifiers = items_of(one.modifiers, ", ");
    const bool is_auxiliary = std::find(modifiers.begin(), modifiers.end(), "auxiliary") != modifiers.end();
    numbers.push_back(is_measured(one.kind) && !is_auxiliary ? ++last : 0);
  }
  return numbers;
}

std::vector<std::pair<std::string, std::string>> requirement_lines(const std::vector<ModelRequirement>& requirements) {
  constexpr std::array<std::pair<RequirementKind, const char*>, 5> kinds{
      {{RequirementKind::dimension, "dimensions"},
       {RequirementKind::tolerance, "tolerances"},
       {RequirementKind::datum, "datums"},
       {RequirementKind::surface_texture, "textures"},
       {RequirementKind::note, "notes"}}};
  std::vector<std::pair<std::string, std::string>> lines;
  for (const auto& [kind, word] : kinds) {
    std::map<std::string, std::size_t> types;
    std::string letters;
    for (const ModelRequirement& one : requirements) {
      if (one.kind != kind) continue;
      ++types[one.type.empty() ? "of unknown type" : one.type];
      append_to_list(letters, one.datums);
    }
    if (types.empty()) continue;
    std::string list;
    for (const auto& [type, count] : types) append_to_list(list, std::to_string(count) + " " + type);
    lines.emplace_back(
        word, std::to_string(count_of(requirements, kind)) + ": " + (kind == RequirementKind::datum ? letters : list));
  }
  return lines;
}

}  // namespace epura::pipeline
