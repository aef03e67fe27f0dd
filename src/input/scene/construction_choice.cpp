// SPDX-License-Identifier: Apache-2.0
#include "scene/construction_choice.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::scene {

namespace {

// Farther points are mistakes, and their coordinates on paper have no digits of mm left.
constexpr double farthest_point = 1e15;

std::optional<int> parse_number_of_element(std::string_view text) {
  const auto number = parse_integer(text);
  if (!number || *number < 0 || *number > INT_MAX) return std::nullopt;
  return static_cast<int>(*number);
}

std::optional<Vec3> parse_direction(std::string_view text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  const Vec3 direction((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  const double size = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  if (!finite(direction) || !(size > 0)) return std::nullopt;
  // The length says nothing, but its square must be a number.
  constexpr double largest = 1e100;
  return size > largest || size < 1 / largest ? direction / size : direction;
}

// [MODEL:]NUMBER, or [MODEL:]NUMBER-NUMBER for an edge.
bool read_element(ConstructionItem& item, std::string_view text, bool is_edge) {
  const auto parts = split(text, ':');
  const auto model = parse_number_of_element(parts.size() == 2 ? parts[0] : "0");
  const auto numbers = split(parts.back(), '-');
  if (parts.size() > 2 || !model || numbers.size() != (is_edge ? 2 : 1)) return false;
  const auto first = parse_number_of_element(numbers.front()), last = parse_number_of_element(numbers.back());
  if (!first || !last || (is_edge && *first == *last)) return false;
  item.model = *model;
  item.numbers = {std::min(*first, *last), std::max(*first, *last)};
  return item.has_element = true;
}

std::optional<Vec3> parse_point(std::string_view text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  const auto is_within = [](double x) { return std::abs(x) <= farthest_point; };
  if (!std::all_of(numbers->begin(), numbers->end(), is_within)) return std::nullopt;
  return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

// [MODEL:]FACE, or X,Y,Z:NX,NY,NZ
bool read_plane(ConstructionItem& item, std::string_view text) {
  if (text.find(',') == std::string_view::npos) return read_element(item, text, false);
  const auto parts = split(text, ':');
  if (parts.size() != 2) return false;
  item.at = parse_point(parts[0]);
  item.direction = parse_direction(parts[1]);
  return item.at && item.direction;
}

// SYMBOL:X,Y,Z
bool read_label(ConstructionItem& item, std::string_view text) {
  const auto parts = split(text, ':');
  if (parts.size() != 2 || parts[0].empty() || parts[0].front() == '_') return false;
  const auto at = parse_point(parts[1]);
  if (!at) return false;
  item.label = NamedPoint{std::string(parts[0]), *at};
  return true;
}

// What is found by a change of planes, too, may say so.
std::string_view without_method(ConstructionItem& item, std::string_view text) {
  constexpr std::string_view method = ":auxiliary";
  const bool has_methods = item.kind == ConstructionKind::true_shape || item.kind == ConstructionKind::true_length;
  if (!has_methods || !text.ends_with(method)) return text;
  item.by_change_of_planes = true;
  return text.substr(0, text.size() - method.size());
}

bool read_argument(ConstructionItem& item, std::string_view text) {
  text = without_method(item, text);
  switch (row_of(item.kind).argument) {
    case ConstructionArgument::none:
      return false;
    case ConstructionArgument::direction:
      item.direction = parse_direction(text);
      return item.direction.has_value();
    case ConstructionArgument::degrees:
      item.degrees = parse_number(text);
      return item.degrees && *item.degrees > 0 && *item.degrees < 180;
    case ConstructionArgument::edge:
      return read_element(item, text, true);
    case ConstructionArgument::vertex:
    case ConstructionArgument::face:
      return read_element(item, text, false);
    case ConstructionArgument::plane:
      return read_plane(item, text);
    case ConstructionArgument::named_point:
      return read_label(item, text);
  }
  return false;
}

std::string form_of(const ConstructionRow& row) {
  const std::string word = row.word;
  switch (row.argument) {
    case ConstructionArgument::none:
      return word + " alone";
    case ConstructionArgument::direction:
      return word + ", or with a direction such as " + word + ":1,1,0";
    case ConstructionArgument::degrees:
      return word + ", or with an angle below 180 degrees such as " + word + ":60";
    case ConstructionArgument::edge:
      return (row.required ? "" : word + ", or ") + word + ":[MODEL:]VERTEX-VERTEX as in JSON, such as " + word +
             ":0-1";
    case ConstructionArgument::vertex:
      return word + ":[MODEL:]VERTEX as in JSON, such as " + word + ":0";
    case ConstructionArgument::face:
      return word + ":[MODEL:]FACE as in JSON, such as " + word + ":0";
    case ConstructionArgument::plane:
      return word + ":[MODEL:]FACE as in JSON, such as " + word + ":0, or " + word +
             ":X,Y,Z:NX,NY,NZ, a point of the plane within 1e15 mm and its normal, such as " + word + ":0,0,10:1,0,1";
    case ConstructionArgument::named_point:
      return word + ":SYMBOL:X,Y,Z within 1e15 mm, such as " + word + ":A_1:0,0,10";
  }
  return word;
}

}  // namespace

ConstructionItem parse_construction(std::string_view text, const std::string& where) {
  const std::size_t colon = text.find(':');
  const std::string word = to_lower(text.substr(0, colon));
  const auto* row = std::find_if(construction_rows.begin(), construction_rows.end(),
                                 [&word](const ConstructionRow& one) { return word == one.word; });
  if (row == construction_rows.end()) {
    std::vector<std::string> words;
    for (const ConstructionRow& one : construction_rows) words.emplace_back(one.word);
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is not a construction",
                did_you_mean(word, words));
  }
  ConstructionItem item{row->kind, std::string(text)};
  const bool sound = colon == std::string_view::npos ? !row->required : read_argument(item, text.substr(colon + 1));
  if (!sound)
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is not a construction", "write " + form_of(*row));
  return item;
}

std::vector<std::string> join_directions(const std::vector<std::string>& words) {
  // How many pieces follow the first.
  const auto pieces_after = [](const std::string& word) {
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos || word.find(',') != std::string::npos) return 0;
    for (const ConstructionRow& row : construction_rows) {
      if (word.substr(0, colon) != row.word) continue;
      if (row.argument == ConstructionArgument::plane) return 4;
      if (row.argument == ConstructionArgument::direction || row.argument == ConstructionArgument::named_point)
        return 2;
    }
    return 0;
  };
  // A number, or the last of a point and the first of a normal.
  const auto is_piece = [](const std::string& word) {
    const auto numbers = split(word, ':');
    return numbers.size() <= 2 &&
           std::all_of(numbers.begin(), numbers.end(), [](const auto& one) { return parse_number(one).has_value(); });
  };
  std::vector<std::string> joined;
  int missing = 0;
  for (const std::string& word : words) {
    if (missing > 0 && is_piece(word)) {
      joined.back() += "," + word;
      --missing;
      continue;
    }
    joined.push_back(word);
    missing = pieces_after(word);
  }
  return joined;
}

}  // namespace epura::scene
