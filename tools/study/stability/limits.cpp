// SPDX-License-Identifier: Apache-2.0
#include "study/stability/limits.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace epura::stability {

namespace {

constexpr double largest_count = 1e6;
// Coordinates are products of steps and sizes; beyond these steps, they would leave the range of doubles.
constexpr double largest_step = 1e300, smallest_step = 1e-300;

End end_of(const Outcome& outcome) {
  if (outcome.measured.empty()) return End::refused;
  return outcome.verdict() == Verdict::limited ? End::limited : End::wrong;
}

// Whether the case goes on after this step.
bool goes_on(const Case& one, double step, const Lab& lab, double seconds, CaseLimit& limit) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome = outcome_of(one, step, lab);
  const bool slow = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds;
  if (outcome.verdict() == Verdict::right && !slow) {
    limit.right = step;
    return true;
  }
  limit.first = step;
  limit.end = outcome.verdict() == Verdict::right ? End::slow : end_of(outcome);
  limit.outcome = std::move(outcome);
  return false;
}

CaseLimit limit_of(const Case& one, const Lab& lab, double seconds) {
  CaseLimit limit{.id = one.id, .what = one.what, .parameter = one.parameter, .right = one.steps.front()};
  for (const double step : one.steps)
    if (!goes_on(one, step, lab, seconds, limit)) return limit;
  std::vector<double> steps = one.steps;
  if (one.kinds) return limit;
  while (const std::optional<double> next = step_beyond(steps)) {
    if (std::abs(*next) > largest_step || std::abs(*next) < smallest_step) {
      limit.end = End::numbers;
      break;
    }
    if (!goes_on(one, *next, lab, seconds, limit)) break;
    steps.push_back(*next);
  }
  return limit;
}

}  // namespace

std::optional<double> step_beyond(std::span<const double> steps) {
  if (steps.size() < 2) return std::nullopt;
  const double before = steps[steps.size() - 2], last = steps.back(), ratio = last / before;
  const bool grows = ratio >= 1.25, shrinks = ratio > 0 && ratio <= 0.8;
  if (!std::isfinite(ratio) || !(grows || shrinks)) return std::nullopt;
  const bool counts = std::all_of(steps.begin(), steps.end(), [](double s) { return s == std::round(s); }) &&
                      std::abs(last) < largest_count;
  if (!counts) return grows ? last * 10 : last / 10;
  const double next = grows ? last * 2 : std::floor(last / 2);
  return next == last || next == 0 ? std::nullopt : std::optional(next);
}

std::vector<CaseLimit> find_limits(std::span<const Case> cases, double size, double seconds, Progress progress) {
  progress.begin("cases", cases.size());
  std::vector<CaseLimit> limits;
  for (const Case& one : cases) {
    limits.push_back(limit_of(one, lab_of(Way::own, size), seconds));
    progress.advance(1);
  }
  return limits;
}

}  // namespace epura::stability
