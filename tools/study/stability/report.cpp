// SPDX-License-Identifier: Apache-2.0
#include "study/stability/report.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/error.hpp"

namespace epura::stability {

namespace {

Verdict verdict_of(const Quantity& quantity) {
  if (quantity.right()) return Verdict::right;
  return quantity.limited() ? Verdict::limited : Verdict::broken;
}

double excess(const Quantity& quantity) {
  return quantity.error() / std::max(quantity.allowed, std::numeric_limits<double>::min());
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::limited:
      return "limited";
    case Verdict::broken:
      break;
  }
  return "broken";
}

Lab lab_of(Way way, double size) {
  if (way == Way::recognised) return {Arithmetic::own, size, true};
  return {static_cast<Arithmetic>(way), size};
}

Verdict Outcome::verdict() const {
  const Quantity* quantity = worst();
  return quantity == nullptr ? Verdict::broken : verdict_of(*quantity);
}

const Quantity* Outcome::worst() const {
  const auto less = [](const Quantity& a, const Quantity& b) {
    const Verdict of_a = verdict_of(a), of_b = verdict_of(b);
    return of_a != of_b ? of_a < of_b : excess(a) < excess(b);
  };
  const auto found = std::max_element(measured.begin(), measured.end(), less);
  return found == measured.end() ? nullptr : &*found;
}

double Outcome::error() const {
  const Quantity* quantity = worst();
  return quantity == nullptr ? std::numeric_limits<double>::infinity() : quantity->error();
}

std::optional<double> CaseReport::breaks_at(Way way) const {
  for (const Row& row : rows)
    if (row.outcomes[static_cast<std::size_t>(way)].verdict() != Verdict::right) return row.step;
  return std::nullopt;
}

Verdict CaseReport::verdict(Way way) const {
  Verdict worst = Verdict::right;
  for (const Row& row : rows) worst = std::max(worst, row.outcomes[static_cast<std::size_t>(way)].verdict());
  return worst;
}

Verdict CaseReport::verdict() const { return std::max(verdict(Way::own), verdict(Way::recognised)); }

Outcome outcome_of(const Case& one, double step, const Lab& lab) {
  try {
    return {one.measure(lab, step), {}};
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

Report run(std::span<const Case> cases, double size, Progress progress) {
  progress.begin("cases", cases.size());
  Report report;
  for (const Case& one : cases) {
    const auto start = std::chrono::steady_clock::now();
    CaseReport& found = report.emplace_back(CaseReport{one.id, one.what, one.parameter, {}, 0});
    for (const double step : one.steps) {
      Row& row = found.rows.emplace_back(Row{step, {}});
      for (std::size_t way = 0; way < way_names.size(); ++way)
        row.outcomes[way] = outcome_of(one, step, lab_of(static_cast<Way>(way), size));
    }
    found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.advance(1);
  }
  return report;
}

}  // namespace epura::stability
