// SPDX-License-Identifier: Apache-2.0
// Continues sweeps beyond the steps of the study until epura is wrong, refuses, or takes too long.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "study/stability/report.hpp"

namespace epura::stability {

enum class End {
  kinds,    ///< steps are kinds rather than sizes, or end at 0: nothing lies beyond
  numbers,  ///< the range of doubles is exhausted, and everything is right
  slow,     ///< a step takes longer than allowed, and everything up to it is right
  limited,  ///< an error that the rounding of the input explains
  refused,  ///< the step is refused, with a reason
  wrong,    ///< a quantity is wrong
};

/// How far a case goes.
struct CaseLimit {
  std::string id, what, parameter;
  double right;                   ///< last step with a right result
  std::optional<double> first{};  ///< step at which it ends, if it does
  End end = End::kinds;
  Outcome outcome{};  ///< of that step
};

/// A step beyond the last of a case: by the factor 2 for counts, 10 or 1/10 otherwise; nothing if its steps are kinds.
std::optional<double> step_beyond(std::span<const double> steps);

/// By epura's own arithmetic. Numbers of parts are scaled by `size`; `seconds` is the time that a step may take.
std::vector<CaseLimit> find_limits(std::span<const Case> cases, double size, double seconds, Progress progress = {});

}  // namespace epura::stability
