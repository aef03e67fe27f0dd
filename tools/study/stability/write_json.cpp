// SPDX-License-Identifier: Apache-2.0
#include "output/json_text.hpp"
#include "study/stability/write.hpp"

namespace epura::stability {

namespace {

std::string number(double value) { return output::json_number(value); }

std::string number(const std::optional<double>& value) { return value ? number(*value) : "null"; }

std::string word(std::string_view text) { return output::json_string(text); }

std::string quantity_of(const Quantity& q) {
  return "{\"name\": " + word(q.name) + ", \"expected\": " + number(q.expected) + ", \"got\": " + number(q.got) +
         ", \"error\": " + number(q.error()) + ", \"allowed\": " + number(q.allowed) +
         ", \"rounding\": " + number(q.rounding) + "}";
}

std::string outcome_of(const Outcome& outcome) {
  std::string text = "{\"verdict\": " + word(name_of(outcome.verdict())) + ", \"error\": " + number(outcome.error());
  if (!outcome.failure.empty()) text += ", \"failure\": " + word(outcome.failure);
  return text + ", \"quantities\": " + output::json_list(outcome.measured, quantity_of) + "}";
}

// {"float32": ..., "double": ..., "epura": ..., "recognised": ...}
template <class Value>
std::string by_way(const Value& value, const std::string& between) {
  std::string text;
  for (std::size_t way = 0; way < way_names.size(); ++way)
    text += (text.empty() ? "" : "," + between) + word(way_names[way]) + ": " + value(way);
  return text;
}

std::string row_of(const Row& row) {
  return "{\"step\": " + number(row.step) + ",\n     " +
         by_way([&](std::size_t way) { return outcome_of(row.outcomes[way]); }, "\n     ") + "}";
}

std::string case_of(const CaseReport& one, bool timings) {
  const auto breaks = [&](std::size_t way) { return number(one.breaks_at(static_cast<Way>(way))); };
  const auto verdict = [&](std::size_t way) { return word(name_of(one.verdict(static_cast<Way>(way)))); };
  std::string text = "{\"id\": " + word(one.id) + ", \"what\": " + word(one.what) +
                     ", \"parameter\": " + word(one.parameter) + ",\n   \"breaks_at\": {" + by_way(breaks, " ") +
                     "}, \"verdict\": {" + by_way(verdict, " ") + "},\n   ";
  if (timings) text += "\"seconds\": " + number(one.seconds) + ", ";
  return text + "\"rows\": " + output::json_lines(one.rows, row_of, "\n    ") + "}";
}

}  // namespace

std::string to_json(const Report& report, bool timings) {
  const auto write = [&](const CaseReport& one) { return case_of(one, timings); };
  return "{\"epura_stability\": 1, \"cases\": " + output::json_lines(report, write, "\n  ") + "}\n";
}

}  // namespace epura::stability
