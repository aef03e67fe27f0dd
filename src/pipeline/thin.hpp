// SPDX-License-Identifier: Apache-2.0
// Finished sheets with fewer lines, for want of time to write all of them.
#pragma once

#include <span>

#include "pipeline/finished_sheet.hpp"
#include "report/report.hpp"

namespace epura::pipeline {

/// Keeps the longest lines of the views, on the sheets and beside them, and notes in `partial` how many go. Says
/// whether so few are left that they take no time.
bool keep_longest_lines(std::span<FinishedSheet> sheets, report::Partial& partial);

}  // namespace epura::pipeline
