// SPDX-License-Identifier: Apache-2.0
// The stages of a run as a table (`epura explain`), and the time that its shortcuts save.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/shortcuts.hpp"
#include "report/report.hpp"

namespace epura {

/// What leaving out saved, by what an item of each stage usually takes.
void estimate_savings(std::vector<report::PlanStep>& plan);

/// Draws again with other shortcuts; returns the bytes of the files, without their reports.
using DrawAgain = std::function<std::string(const pipeline::Shortcuts&)>;

/// Time saved by shortcuts, from alternating runs with and without each effective shortcut: the median of
/// the differences in processor time. It is that of the whole run, and is given at the first step of the stage. All
/// runs must give the same bytes.
void measure_savings(std::vector<report::PlanStep>& plan, const pipeline::Shortcuts& used, const DrawAgain& again);

/// A line for each step: stage, view, run or skipped, seconds of the shortcut's test and of the stage, seconds saved as
/// estimated and as measured, items in and out, why. Columns that nothing is known of are left out.
std::string plan_table(const std::vector<report::PlanStep>& plan);

}  // namespace epura
