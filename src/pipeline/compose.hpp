// SPDX-License-Identifier: Apache-2.0
// Positioned views -> sheets.
#pragma once

#include <span>
#include <vector>

#include "pipeline/annotations.hpp"
#include "pipeline/budget.hpp"
#include "pipeline/draw_view.hpp"
#include "pipeline/finished_sheet.hpp"
#include "pipeline/layout.hpp"
#include "pipeline/view_plan.hpp"
#include "scene/description.hpp"

namespace epura::pipeline {

/// Composes the views of a sheet, in order, with their annotations and the sheet's furniture. Work for which there is
/// no time is omitted, and noted in the budget. A sheet that leaves out more dimensions than `input` permits is
/// returned unfinished, with `left_out` alone.
FinishedSheet compose(const SheetInput& input, std::vector<ViewResult>& results, const Budget& budget);

}  // namespace epura::pipeline
