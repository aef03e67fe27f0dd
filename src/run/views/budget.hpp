// SPDX-License-Identifier: Apache-2.0
// How a run with a time limit divides its time, and what it omits.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/progress.hpp"
#include "report/report.hpp"

namespace epura::pipeline {

/// Deadline in seconds for work that was restarted with less to do when time was over.
constexpr double last_line(double limit) { return std::max(1.05 * limit, limit + 0.05); }
/// Deadline after which the process is ended from outside. The rest of the promised margin, a tenth and 0.3 s, is for
/// the system: the program is loaded before the clock begins, and its threads and memory are released after the last
/// line. On a busy machine, releasing a gigabyte takes a quarter of a second.
constexpr double last_second(double limit) { return std::max(1.1 * limit, limit + 0.15); }

/// The time of a view or of a whole run.
struct Budget {
  Progress run;              ///< deadline for everything
  Progress lines;            ///< deadline for finding and drawing the lines of the view
  report::Partial& partial;  ///< work left undone

  /// For work that is restarted with less to do, and must be completed.
  [[nodiscard]] Progress last() const {
    const double limit = run.time_limit().value_or(0);
    return run.with_more_time(last_line(limit) - limit);
  }

  /// Returns `make(progress)`, which may take half of the remaining time. If that does not suffice, the work is omitted
  /// and this is noted.
  template <class Make>
  auto or_nothing(const Make& make) const -> decltype(make(run)) {
    try {
      return make(run.with_part_of_the_time(0.5));
    } catch (const OutOfTime& cut) {
      partial.add_stage(cut.stage);
      return {};
    }
  }
};

/// The part of the time left that is spent on how exact a drawing is.
constexpr double part_for_judging = 0.1;

/// So few lines take negligible time.
constexpr std::size_t few_lines = 64;
/// Work that is repeated for fewer lines is repeated for the longest eighth of them.
constexpr std::size_t fewer(std::size_t lines) { return std::min(lines, std::max(lines / 8, few_lines)); }

}  // namespace epura::pipeline
