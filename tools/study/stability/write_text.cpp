// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "study/stability/write.hpp"

namespace epura::stability {

namespace {

constexpr int error_digits = 3, limit_digits = 6;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

std::string step_text(const std::optional<double>& step) { return step ? format_rounded(*step, error_digits) : "-"; }

std::string summary_line(const CaseReport& one) {
  std::string line = padded(one.id, 4) + padded(one.what, 62);
  for (std::size_t way = 0; way < way_names.size(); ++way)
    line += padded(step_text(one.breaks_at(static_cast<Way>(way))), 10);
  return line + std::string(name_of(one.verdict())) + "\n";
}

std::string row_line(const Row& row, std::size_t way) {
  const Outcome& outcome = row.outcomes[way];
  std::string line = "  " + padded(format_rounded(row.step, error_digits), 10) +
                     padded(std::string(way_names[way]), 9) + padded(std::string(name_of(outcome.verdict())), 9);
  const Quantity* quantity = outcome.worst();
  if (quantity == nullptr) return line + outcome.failure + "\n";
  return line + padded(quantity->name, 16) + padded(format_rounded(quantity->expected, 9), 16) +
         padded(format_rounded(quantity->got, 9), 16) + "error " +
         padded(format_rounded(quantity->error(), error_digits), 10) + "allowed " +
         format_rounded(quantity->allowed, error_digits) + "\n";
}

// Why a case ends.
std::string reason(const CaseLimit& limit) {
  switch (limit.end) {
    case End::kinds:
      return "nothing lies beyond";
    case End::numbers:
      return "no end in the range of doubles";
    case End::slow:
      return "takes too long";
    case End::refused:
      return "refused: " + limit.outcome.failure;
    case End::limited:
    case End::wrong:
      break;
  }
  const Quantity* quantity = limit.outcome.worst();
  return std::string(limit.end == End::limited ? "limited by rounding: " : "wrong: ") + quantity->name + " " +
         format_rounded(quantity->got, limit_digits) + " instead of " +
         format_rounded(quantity->expected, limit_digits);
}

// Quotes text that could be taken for two fields (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string quantity_fields(const Quantity& q) {
  const Outcome alone{{q}, {}};
  std::string line = field(q.name);
  for (const double number : {q.expected, q.got, q.error(), q.allowed, q.rounding}) line += "," + format_number(number);
  return line + "," + std::string(name_of(alone.verdict())) + ",";
}

}  // namespace

std::string to_text(const Report& report, bool rows) {
  std::string text = padded("", 4) + padded("case", 62);
  for (const std::string_view name : way_names) text += padded(std::string(name), 10);
  text += "verdict on epura\n";
  for (const CaseReport& one : report) {
    text += summary_line(one);
    if (!rows) continue;
    text += "  by " + one.parameter + "\n";
    for (const Row& row : one.rows)
      for (std::size_t way = 0; way < way_names.size(); ++way) text += row_line(row, way);
  }
  return text + "\nThe first step that is not right, of steps from mild to extreme; - where all are right.\n";
}

std::string to_text(std::span<const CaseLimit> limits) {
  std::string text = padded("", 4) + padded("case", 56) + padded("right up to", 12) + "ends at\n";
  for (const CaseLimit& limit : limits)
    text += padded(limit.id, 4) + padded(limit.what, 56) + padded(step_text(limit.right), 12) +
            padded(step_text(limit.first), 8) + reason(limit) + "\n";
  return text;
}

std::string to_csv(const Report& report) {
  std::string text = "case,step,way,quantity,expected,got,error,allowed,rounding,verdict,failure\n";
  for (const CaseReport& one : report)
    for (const Row& row : one.rows)
      for (std::size_t way = 0; way < way_names.size(); ++way) {
        const Outcome& outcome = row.outcomes[way];
        const std::string head = one.id + "," + format_number(row.step) + "," + std::string(way_names[way]) + ",";
        for (const Quantity& q : outcome.measured) text += head + quantity_fields(q) + "\n";
        if (outcome.measured.empty()) text += head + ",,,inf,,,broken," + field(outcome.failure) + "\n";
      }
  return text;
}

}  // namespace epura::stability
