// SPDX-License-Identifier: Apache-2.0
#include "sizes/note_cursor.hpp"

#include <array>
#include <utility>

#include "base/error.hpp"

namespace epura::sheet {

bool NoteCursor::take(std::string_view sign) {
  if (!rest.starts_with(sign)) return false;
  rest.remove_prefix(sign.size());
  return true;
}

std::optional<NumberText> NoteCursor::take_number() {
  const std::optional<NumberText> number = number_at(rest);
  if (number) rest.remove_prefix(number->bytes);
  return number;
}

std::optional<double> NoteCursor::take_unit() {
  const std::optional<UnitText> unit = unit_at(rest);
  if (unit) rest.remove_prefix(unit->bytes);
  return unit ? std::optional(unit->millimetres) : std::nullopt;
}

std::optional<NumberText> NoteCursor::take_degrees() {
  const std::optional<NumberText> angle = degrees_at(rest);
  if (angle) rest.remove_prefix(angle->bytes);
  return angle;
}

NotedSign NoteCursor::take_sign() {
  constexpr std::array<std::pair<std::string_view, NotedSign>, 5> signs{{{"S⌀", NotedSign::sphere},
                                                                         {"SR", NotedSign::sphere_radius},
                                                                         {"⌀", NotedSign::diameter},
                                                                         {"R", NotedSign::radius},
                                                                         {"□", NotedSign::square}}};
  const std::string_view before = rest;
  const auto is_before_number = [this] {
    skip_spaces();
    return number_at(rest).has_value();
  };
  for (const auto& [sign, meaning] : signs) {
    if (take(sign) && is_before_number()) return meaning;
    rest = before;
  }
  const auto use = take_use(WordUse::diameter, WordUse::drilled, WordUse::radius, WordUse::square);
  if (use && is_before_number())
    return *use == WordUse::radius   ? NotedSign::radius
           : *use == WordUse::square ? NotedSign::square
                                     : NotedSign::diameter;
  rest = before;
  return NotedSign::none;
}

void NoteCursor::skip_spaces() {
  while (take(" ")) continue;
}

}  // namespace epura::sheet
