// SPDX-License-Identifier: Apache-2.0
// The result of a run: sheets ready to be written, with fewer lines if time is short.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "report/report.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::pipeline {

/// A sheet, and its data for JSON.
struct FinishedSheet {
  sheet::Sheet sheet;
  double scale = 1;                              ///< main scale, mm of paper per unit of the world
  std::vector<drawing::ViewDrawing> drawings{};  ///< in order of the views; empty if no target needs them
  std::vector<std::string> warnings{};           ///< requests that could not be met
  sheet::Paper paper{};
};

/// Marks a sheet that lacks something since time was over in a stage; once more by another stage.
void mark_partial(FinishedSheet& sheet, const std::string& stage);

/// Keeps the longest lines of the views, on the sheets and in the drawings, and notes in `partial` how many go. Says
/// whether so few are left that they take no time.
bool keep_longest_lines(std::span<FinishedSheet> sheets, report::Partial& partial);

}  // namespace epura::pipeline
