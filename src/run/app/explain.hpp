// SPDX-License-Identifier: Apache-2.0
// Formats the stages of a run as a table (`epura explain`), and determines the time saved by its shortcuts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "views/shortcuts.hpp"

namespace epura {

/// Estimates the time saved by skipping, from the usual time per item of each stage.
void estimate_savings(std::vector<report::PlanStep>& plan);

/// Draws again with other shortcuts; returns the bytes of the files, without their reports.
using DrawAgain = std::function<std::string(const pipeline::Shortcuts&)>;

/// Measures the time saved by shortcuts, by alternating runs with and without each effective shortcut: the median of
/// the differences in processor time of the whole run. It is stored in the first step of the stage. All runs must give
/// the same bytes.
void measure_savings(std::vector<report::PlanStep>& plan, const pipeline::Shortcuts& used, const DrawAgain& again);

/// Returns a line for each step: stage, view, run or skipped, times in ms (test of the shortcut, stage, estimated
/// saving, measured saving), items in and out, why. Empty columns are omitted.
std::string plan_table(const std::vector<report::PlanStep>& plan);

}  // namespace epura
