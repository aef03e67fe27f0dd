// SPDX-License-Identifier: Apache-2.0
// How a run with a time limit divides its time, and what it omits.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/progress.hpp"
#include "report/report.hpp"

namespace epura::pipeline {

/// By when a run whose time is over has made what it began again, in seconds.
constexpr double last_line(double limit) { return std::max(1.05 * limit, limit + 0.05); }
/// By when its process is ended from outside. The rest of what is promised, a tenth and 0.3 s, is for the system: the
/// program is loaded before the clock begins, and its threads and memory go after the last line. On a busy machine a
/// gigabyte takes a quarter of a second.
constexpr double last_second(double limit) { return std::max(1.1 * limit, limit + 0.15); }

/// Of a view or of a whole run.
struct Budget {
  Progress run;              ///< all is to be done by then
  Progress lines;            ///< the lines of the view are to be decided and drawn by then
  report::Partial& partial;  ///< what is left undone

  /// For what is begun again with less to do, and has to come to an end.
  [[nodiscard]] Progress last() const {
    const double limit = run.time_limit().value_or(0);
    return run.with_more_time(last_line(limit) - limit);
  }

  /// What `make(progress)` gives, which may take half of the time that is left. Where that does not suffice, it is left
  /// out, and said.
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

/// So few lines take no time worth the name.
constexpr std::size_t few_lines = 64;
/// What is made again of fewer lines is made of the longest eighth of them.
constexpr std::size_t fewer(std::size_t lines) { return std::min(lines, std::max(lines / 8, few_lines)); }

}  // namespace epura::pipeline
