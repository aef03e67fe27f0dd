// SPDX-License-Identifier: Apache-2.0
// Formats the progress line for a terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/progress.hpp"

namespace epura {

/// "2:05", "1:02:05": minutes and seconds, with hours if there are any, rounded up.
std::string clock_text(double seconds);

/// The time left of a stage as it is shown: from the latest estimate it is counted down, and never up. A stage that
/// outlives its estimate promises nothing more.
class TimeLeft {
 public:
  /// To be called with the standings of a run in their order. Seconds; empty while unknown.
  std::optional<double> at(const Standing& standing);

 private:
  std::string stage_;
  std::size_t done_ = 0;
  std::optional<double> end_;  ///< seconds since the stage began
};

/// For example "epura: hiding lines  [########------------]  42 %  0:03 left", with at most `width` characters. If the
/// amount of work is unknown, the elapsed time is shown instead.
std::string progress_line(const Standing& standing, std::optional<double> seconds_left, std::size_t width);

}  // namespace epura
