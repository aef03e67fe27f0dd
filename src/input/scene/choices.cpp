// SPDX-License-Identifier: Apache-2.0
#include "scene/choices.hpp"

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"

namespace epura::scene {

namespace {

PaperChoice custom_size(std::string_view text, const std::string& where) {
  const auto parts = split(text, 'x');
  const auto width = parts.size() == 2 ? parse_number(parts[0]) : std::nullopt;
  const auto height = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  if (!width || !height)
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is not a paper size",
                "write none, auto, A0 to A4, ANSI-A to ANSI-E, letter, tabloid, ledger, or width x height in mm such "
                "as 300x200");
  const auto usable = [](double side) { return side >= 1 && side <= longest_side; };
  if (!usable(*width) || !usable(*height))
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is not a usable paper size",
                "sides may be 1 to " + format_number(longest_side) + " mm long");
  return {PaperChoice::Kind::custom, 0, {*width, *height}};
}

}  // namespace

double millimetres(Unit unit) {
  constexpr std::array<double, 3> lengths{1, 25.4, 1000};
  return lengths[static_cast<std::size_t>(unit)];
}

bool names_font_file(const std::string& font) {
  const std::string lower = to_lower(font);
  return font.find('/') != std::string::npos || lower.ends_with(".ttf") || lower.ends_with(".otf") ||
         lower.ends_with(".ttc") || lower.ends_with(".otc");
}

std::string ProjectionRequest::text() const {
  std::string all = name;
  for (const auto& [key, value] : assignments) all += ":" + key + "=" + value;
  return all;
}

ScaleChoice parse_scale(std::string_view text, const std::string& where) {
  const std::string lower = to_lower(text);
  if (lower == "fit") return {};
  if (lower == "auto") return {std::nullopt, true};
  const bool is_percent = text.ends_with('%');
  const auto parts =
      split(is_percent ? text.substr(0, text.size() - 1) : text, text.find(':') == std::string_view::npos ? '/' : ':');
  const auto paper = parse_number(parts[0]);
  const auto model =
      parts.size() == 2 && !is_percent ? parse_number(parts[1]) : std::optional<double>(is_percent ? 100 : 1);
  const double scale = paper && model && parts.size() <= (is_percent ? 1U : 2U) ? *paper / *model : 0;
  if (!is_usable(scale) || !(scale >= 1 / largest_number) || !(*paper > 0) || std::isinf(*model))
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' is not a scale",
                "write fit, auto, paper:model such as 1:2 or 5:1, or a number above 0");
  return {scale, false};
}

PaperChoice parse_paper_size(std::string_view text, const std::string& where) {
  const std::string lower = to_lower(text);
  if (lower == "none") return {PaperChoice::Kind::none, 0, {0, 0}};
  if (lower == "auto") return {PaperChoice::Kind::automatic, 0, {0, 0}};
  if (lower.size() == 2 && lower[0] == 'a' && lower[1] >= '0' && lower[1] <= '4')
    return {PaperChoice::Kind::iso, lower[1] - '0', {0, 0}};
  if (lower == "ansi-auto" || lower == "ansi auto") return {PaperChoice::Kind::automatic_ansi, 0, {0, 0}};
  if (lower.size() == 6 && (lower.starts_with("ansi-") || lower.starts_with("ansi ")) && lower[5] >= 'a' &&
      lower[5] <= 'e')
    return {PaperChoice::Kind::ansi, lower[5] - 'a', {0, 0}};
  // What printers call the first two.
  if (lower == "letter") return {PaperChoice::Kind::ansi, 0, {0, 0}};
  if (lower == "tabloid" || lower == "ledger") return {PaperChoice::Kind::ansi, 1, {0, 0}};
  return custom_size(lower, where);
}

BreakChoice::Part parse_break(std::string_view text, const std::string& where) {
  const std::string hint = "axis and two places on it, such as x:40:160; without a place, up to the end: x:40:";
  const auto refuse = [&](const std::string& reason) {
    throw Error(ErrorKind::input, where, "'" + std::string(text) + "' " + reason, hint);
  };
  const std::vector<std::string_view> words = split(text, ':');
  const std::string axes = "xyz", axis = to_lower(words[0]);
  if (words.size() != 3 || axis.size() != 1 || axes.find(axis) == std::string::npos) refuse("is not a break");
  BreakChoice::Part part{static_cast<int>(axes.find(axis)), -HUGE_VAL, HUGE_VAL};
  const auto read = [&](std::string_view word, double& place) {
    if (word.empty()) return;
    const auto number = parse_number(word);
    if (!number || !is_usable(*number)) refuse("is not a break: '" + std::string(word) + "' is not a number");
    place = *number;
  };
  read(words[1], part.from);
  read(words[2], part.to);
  if (words[1].empty() && words[2].empty()) refuse("leaves everything out");
  if (!(part.from < part.to)) refuse("leaves nothing out: the second place is not beyond the first");
  return part;
}

ProjectionRequest parse_request(std::string_view text) {
  const auto refuse = [](const std::string& where, const std::string& reason, const std::string& hint = {}) {
    throw Error(ErrorKind::input, where, reason, hint);
  };
  const std::vector<std::string_view> parts = split(text, ':');
  const std::string where(text);
  ProjectionRequest request{std::string(parts[0]), {}};
  if (request.name.empty()) refuse(where, "the name of the projection is missing", "NAME[:key=value]...");
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    if (equals == std::string_view::npos && request.name == "saved" && i == 1) {
      request.assignments.emplace_back("view", parts[i]);
      continue;
    }
    if (equals == std::string_view::npos || equals == 0)
      refuse(where, std::string("'").append(parts[i]) + "' is not a key=value",
             "name the parameter, as in oblique:angle=30; 'epura plugins " + request.name + "' lists them");
    const std::string key(parts[i].substr(0, equals));
    for (const auto& [earlier, value] : request.assignments)
      if (earlier == key) refuse(request.name + ":" + key, "is given twice");
    request.assignments.emplace_back(key, parts[i].substr(equals + 1));
  }
  return request;
}

}  // namespace epura::scene
