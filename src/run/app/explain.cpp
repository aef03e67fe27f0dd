// SPDX-License-Identifier: Apache-2.0
#include "app/explain.hpp"

#include <algorithm>
#include <ctime>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

constexpr int rounds = 5;

// The usual time per item of each stage in seconds, on one core of a server of 2023 (docs/accuracy.md).
const std::vector<std::pair<std::string, double>>& usual_seconds() {
  static const std::vector<std::pair<std::string, double>> table{
      {"clip", 2e-7}, {"intersections", 4e-7}, {"visibility", 1e-6}, {"hidden", 5e-7}, {"text", 2e-3}};
  return table;
}

// Processor time of all threads, which other programs hardly affect.
double seconds_of(const DrawAgain& again, const pipeline::Shortcuts& leave_out, const std::string& expected) {
  const std::clock_t start = std::clock();
  const bool same = again(leave_out) == expected;
  const std::clock_t end = std::clock();
  check(same, "a stage that is skipped has no influence on the drawing");
  return static_cast<double>(end - start) / CLOCKS_PER_SEC;
}

// Every round has both runs, in alternating order, since the first one warms the caches for the next.
double measured_saving(const pipeline::Shortcuts& with, const pipeline::Shortcuts& without, const DrawAgain& again,
                       const std::string& expected) {
  std::vector<double> differences;
  for (int round = 0; round < rounds; ++round) {
    const bool first = round % 2 == 0;
    const double one = seconds_of(again, first ? with : without, expected);
    const double two = seconds_of(again, first ? without : with, expected);
    differences.push_back(first ? two - one : one - two);
  }
  std::sort(differences.begin(), differences.end());
  return differences[rounds / 2];
}

std::string milliseconds(const std::optional<double>& seconds) {
  return seconds ? format_fixed(1000 * *seconds, 3) : "-";
}

using Row = std::vector<std::string>;

Row row_of(const report::PlanStep& step) {
  return {step.stage,
          step.view.empty() ? "-" : step.view,
          step.run ? "run" : "skipped",
          milliseconds(step.times.certificate),
          milliseconds(step.times.stage),
          milliseconds(step.times.estimated),
          milliseconds(step.times.measured),
          std::to_string(step.items_in),
          std::to_string(step.items_out),
          step.why};
}

bool says_something(const std::vector<Row>& rows, std::size_t column) {
  return std::any_of(rows.begin() + 1, rows.end(), [&](const Row& row) { return row[column] != "-"; });
}

// Aligns columns under their headings; the last one is not padded.
std::string aligned(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (!says_something(rows, column)) continue;
      std::size_t width = 0;
      for (const Row& other : rows) width = std::max(width, other[column].size());
      line += row[column];
      if (column + 1 < row.size()) line.append(width - row[column].size() + 2, ' ');
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace

void estimate_savings(std::vector<report::PlanStep>& plan) {
  for (report::PlanStep& step : plan)
    for (const auto& [stage, seconds] : usual_seconds())
      if (step.stage == stage && step.skipped > 0) step.times.estimated = seconds * static_cast<double>(step.skipped);
}

void measure_savings(std::vector<report::PlanStep>& plan, const pipeline::Shortcuts& used, const DrawAgain& again) {
  const std::string expected = again(used);
  for (const auto& entry : pipeline::shortcut_names()) {
    const auto spares = [&](const report::PlanStep& step) { return step.stage == entry.first && step.skipped > 0; };
    const auto step = std::find_if(plan.begin(), plan.end(), spares);
    if (step == plan.end()) continue;
    pipeline::Shortcuts without = used;
    without.*entry.second = false;
    step->times.measured = measured_saving(used, without, again, expected);
  }
}

std::string plan_table(const std::vector<report::PlanStep>& plan) {
  std::vector<Row> rows{{"stage", "view", "plan", "shortcut", "took", "saved about", "saved", "in", "out", "why"}};
  for (const report::PlanStep& step : plan) rows.push_back(row_of(step));
  return "times in ms\n" + aligned(rows);
}

}  // namespace epura
