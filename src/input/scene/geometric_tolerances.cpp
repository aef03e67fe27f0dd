// SPDX-License-Identifier: Apache-2.0
#include "scene/geometric_tolerances.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::scene {

namespace {

// Material and form: ISO 2692, ISO 10579, ISO 1101.
constexpr std::string_view circled_modifiers = "MLRPFTU";
constexpr std::array<std::string_view, 5> word_modifiers{"CZ", "SZ", "UZ", "OZ", "NC"};
constexpr std::array<std::string_view, 4> diameter_signs{"Ø", "⌀", "ø", "∅"};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (const std::string_view word : split(text, ' '))
    if (!word.empty()) words.push_back(word);
  return words;
}

bool is_circled(std::string_view word) {
  return word.size() == 1 && circled_modifiers.find(word[0]) != std::string_view::npos;
}

// "S⌀" or "⌀", which is removed from the text.
std::string take_diameter(std::string_view& text) {
  const bool sphere = text.starts_with('S');
  for (const std::string_view sign : diameter_signs) {
    if (!text.substr(sphere ? 1 : 0).starts_with(sign)) continue;
    text.remove_prefix(sign.size() + (sphere ? 1 : 0));
    return sphere ? "S⌀" : "⌀";
  }
  return {};
}

std::string usual_modifiers() {
  return "modifiers are M, L, R, P, F, T or U, which are drawn in circles, and CZ, SZ, UZ, OZ or NC";
}

}  // namespace

FrameCell parse_zone(std::string_view text, const std::string& where) {
  const std::vector<std::string_view> words = words_of(text);
  std::string_view first = words.empty() ? std::string_view() : words.front();
  const std::string sign = take_diameter(first);
  const auto width = parse_number(first);
  if (!width || !std::isfinite(*width) || *width < 0)
    refuse_input(where, "'" + std::string(text) + "' is not a tolerance zone",
                 "write its width, 0.1, or diameter, Ø0.1");
  FrameCell cell;
  cell.push_back({sign + std::string(first)});
  bool allows_number = false, has_material = false;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string word(words[i]);
    const bool known = std::find(word_modifiers.begin(), word_modifiers.end(), word) != word_modifiers.end();
    const auto number = parse_number(word);
    if (!is_circled(word) && !known && !(allows_number && number && *number > 0))
      refuse_input(where, "'" + word + "' is not a modifier of a tolerance zone", usual_modifiers());
    cell.push_back({word, is_circled(word)});
    allows_number = word == "P";  // length of the projected zone
    has_material = has_material || word == "M" || word == "L";
  }
  if (*width == 0 && !has_material)
    refuse_input(where, "the tolerance zone is 0 wide", "only zones with M or L may be: Ø0 M");
  return cell;
}

void expect_datum_letter(std::string_view letter, const std::string& where) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z' && c != 'I' && c != 'O' && c != 'Q'; };
  if (letter.empty() || letter.size() > 2 || !std::all_of(letter.begin(), letter.end(), is_capital))
    refuse_input(where, "'" + std::string(letter) + "' is not a datum letter",
                 "use one or two of A to Z without I, O and Q");
}

FrameCell parse_datum(std::string_view text, const std::string& where, std::vector<std::string>& letters) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.empty()) refuse_input(where, "a datum is empty", "write its letter, such as A");
  for (const std::string_view letter : split(words.front(), '-')) {
    expect_datum_letter(letter, where);
    letters.emplace_back(letter);
  }
  FrameCell cell;
  cell.push_back({std::string(words.front())});
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] != "M" && words[i] != "L" && words[i] != "R")
      refuse_input(where, "'" + std::string(words[i]) + "' is not a modifier of a datum", "modifiers are M, L and R");
    cell.push_back({std::string(words[i]), true});
  }
  return cell;
}

}  // namespace epura::scene
