// SPDX-License-Identifier: Apache-2.0
// A comparison as text and as JSON.
#include <array>
#include <cmath>
#include <cstddef>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "compare/align_views.hpp"
#include "compare/comparison.hpp"
#include "output/json_text.hpp"

namespace epura::compare {

namespace {

std::string millimetres(double length) { return format_fixed(length, 3) + " mm"; }

std::string place(const Vec2& p) { return "(" + format_fixed(p.x, 3) + ", " + format_fixed(p.y, 3) + ")"; }

// The first few edges of a list.
std::string format_edges(const std::string& origin) {
  constexpr std::size_t max = 3;
  const auto edges = split(origin, ' ');
  std::string text = edges.size() == 1 ? ", edge" : ", edges";
  for (std::size_t i = 0; i < std::min(edges.size(), max); ++i) text.append(" ").append(edges[i]);
  return edges.size() > max ? text + " and " + std::to_string(edges.size() - max) + " more" : text;
}

std::string format_line(const Difference& d) {
  const std::string look = d.before == d.after || d.before.empty() || d.after.empty()
                               ? (d.after.empty() ? d.before : d.after)
                               : d.before + " -> " + d.after;
  const bool is_area = look.ends_with(" area");
  std::string text = (is_area ? "border of " + look : look + " line") + ", " + millimetres(d.length) + ", " +
                     place(d.from) + " to " + place(d.to);
  if (d.change == Change::moved) text += ", by " + millimetres(d.distance);
  return d.origin.empty() ? text : text + format_edges(d.origin);
}

std::string format_text(const Difference& d) {
  std::string text = "text '" + (d.after.empty() ? d.before : d.after) + "'";
  if (d.change == Change::text) {
    const std::string size = measured_by(d);
    text = (size.empty() ? "" : size + " ") + "'" + d.before + "' -> '" + d.after + "'";
  }
  text += " at " + place(d.from);
  return d.change == Change::moved ? text + ", by " + millimetres(d.distance) : text;
}

std::string format_difference(const Difference& d, bool pages) {
  std::string text(name_of(d.change));
  text.resize(11, ' ');
  if (pages) text += "page " + std::to_string(d.page) + ", ";
  if (!d.view.empty()) text += d.view + ": ";
  if (d.change == Change::size) return text + "sheet of " + d.before + " -> " + d.after;
  if (d.is_view)
    return text + (d.view.find(',') == std::string::npos ? "the whole view, by " : "whole views, by ") + place(d.to) +
           " mm";
  return text + (d.is_text ? format_text(d) : format_line(d));
}

constexpr std::size_t kinds = static_cast<std::size_t>(Change::text) + 1;

std::array<int, kinds> counts(const Comparison& comparison) {
  std::array<int, kinds> counts{};
  for (const Difference& d : comparison.differences) ++counts[static_cast<std::size_t>(d.change)];
  return counts;
}

std::string_view name_of(const RequirementChange& change) {
  return change.before.empty() ? "added" : change.after.empty() ? "removed" : "changed";
}

std::string format_change(const RequirementChange& change) {
  std::string text(name_of(change));
  text.resize(11, ' ');
  text += "requirement: " + one_line(change.before);
  return text + (change.before.empty() || change.after.empty() ? "" : " -> ") + one_line(change.after);
}

std::string number_of_requirements(const Comparison& comparison) {
  const std::size_t number = comparison.requirements.size();
  return std::to_string(number) + (number == 1 ? " requirement differs" : " requirements differ");
}

std::string point(const Vec2& p) { return output::json_list(std::array{p.x, p.y}, output::json_number); }

std::string text_or_null(const std::string& text) { return text.empty() ? "null" : output::json_string(text); }

std::string json_of(const RequirementChange& change) {
  return "{\"change\": " + output::json_string(name_of(change)) + ", \"before\": " + text_or_null(change.before) +
         ", \"after\": " + text_or_null(change.after) + "}";
}

std::string json_of(const Difference& d) {
  std::string json = "{\"change\": " + output::json_string(name_of(d.change)) +
                     ", \"page\": " + std::to_string(d.page) + ", \"view\": " + text_or_null(d.view) + ", \"of\": " +
                     (d.change == Change::size ? "\"sheet\""
                      : d.is_text              ? "\"text\""
                      : d.is_view              ? "\"view\""
                                               : "\"line\"") +
                     ", \"before\": " + text_or_null(d.before) + ", \"after\": " + text_or_null(d.after);
  if (d.change == Change::size) return json + "}";
  if (d.is_view) return json + ", \"by\": " + point(d.to) + ", \"distance\": " + output::json_number(d.distance) + "}";
  json += ", \"from\": " + point(d.from) + ", \"to\": " + point(d.to);
  if (!d.is_text) json += ", \"length\": " + output::json_number(d.length);
  if (d.change == Change::moved) json += ", \"distance\": " + output::json_number(d.distance);
  if (!d.origin.empty()) json += ", \"edges\": " + output::json_list(split(d.origin, ' '), output::json_string);
  return json + "}";
}

}  // namespace

std::string format_comparison(const Comparison& comparison, double tolerance) {
  std::string text;
  for (const RequirementChange& change : comparison.requirements) text += format_change(change) + "\n";
  if (!comparison.requirements.empty()) text += number_of_requirements(comparison) + "\n";
  for (const Difference& d : comparison.differences) text += format_difference(d, comparison.pages.size() > 1) + "\n";
  if (!comparison.compares_texts) text += "texts of a PDF file are compared with those of another one only\n";
  if (text.empty() || comparison.differences.empty())
    return text + "no differences above " + format_number(tolerance) + " mm\n";
  const std::array<int, kinds> count = counts(comparison);
  text += std::to_string(comparison.differences.size()) +
          (comparison.differences.size() == 1 ? " difference" : " differences") + " above " + format_number(tolerance) +
          " mm:";
  std::string separator = " ";
  for (std::size_t i = 0; i < kinds; ++i) {
    if (count[i] == 0) continue;
    text.append(separator).append(std::to_string(count[i])).append(" ").append(name_of(static_cast<Change>(i)));
    separator = ", ";
  }
  if (comparison.followers > 0)
    text += "; " + std::to_string(comparison.followers) +
            (comparison.followers == 1 ? " more follows" : " more follow") + " from the changed sizes";
  return text + "\n";
}

std::string to_markdown(const Comparison& comparison, double tolerance, const std::string& before,
                        const std::string& after) {
  constexpr std::size_t max_listed = 16;  // with the heading, the number and what is left out, 20 lines
  const std::string words = format_comparison(comparison, tolerance);
  std::vector<std::string_view> lines = split(words, '\n');
  std::erase(lines, std::string_view());
  std::string text = "**" + before + " → " + after + "**: ", number = number_of_requirements(comparison);
  if (!comparison.requirements.empty()) text += number + "; ";
  text += std::string(lines.back()) + "\n\n";
  lines.pop_back();
  std::erase(lines, number);
  for (std::size_t i = 0; i < std::min(lines.size(), max_listed); ++i)
    text.append("- `").append(lines[i]).append("`\n");
  if (lines.size() > max_listed) text += "- and " + std::to_string(lines.size() - max_listed) + " more\n";
  return text;
}

std::string to_json(const Comparison& comparison, double tolerance, const std::string& before,
                    const std::string& after) {
  std::string json = "{\"epura_compare\": 1, \"before\": " + output::json_string(before) +
                     ", \"after\": " + output::json_string(after) +
                     ",\n \"tolerance\": " + output::json_number(tolerance) +
                     ", \"same\": " + (comparison.is_same() ? "true" : "false") +
                     ", \"texts_compared\": " + (comparison.compares_texts ? "true" : "false") +
                     ", \"following\": " + std::to_string(comparison.followers) + ",\n \"counts\": {";
  const std::array<int, kinds> count = counts(comparison);
  for (std::size_t i = 0; i < kinds; ++i)
    json +=
        (i > 0 ? ", " : "") + output::json_string(name_of(static_cast<Change>(i))) + ": " + std::to_string(count[i]);
  const auto write = [](const auto& one) { return json_of(one); };
  return json + "},\n \"differences\": " + output::json_lines(comparison.differences, write, "\n  ") +
         ",\n \"requirements\": " + output::json_lines(comparison.requirements, write, "\n  ") + "}\n";
}

}  // namespace epura::compare
