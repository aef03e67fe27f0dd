// SPDX-License-Identifier: Apache-2.0
// How a run that has a time limit spends its time, and what it leaves undone.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/progress.hpp"
#include "output/write.hpp"

namespace epura {

/// Of a view or of a whole run.
struct Budget {
  Progress run;      ///< all is to be done by then
  Progress lines;    ///< the lines of the view are to be decided and drawn by then
  Partial& partial;  ///< what is left undone

  /// For what is begun again with less to do, and has to come to an end.
  [[nodiscard]] Progress last() const {
    constexpr double part = 0.1, seconds = 0.1;  // the end of the process takes some time, too
    return run.with_more_time(part * run.time_limit().value_or(0) + seconds);
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

}  // namespace epura
