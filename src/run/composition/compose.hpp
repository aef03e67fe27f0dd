// SPDX-License-Identifier: Apache-2.0
// Positioned views -> sheets.
#pragma once

#include <span>
#include <vector>

#include "composition/annotations.hpp"
#include "composition/finished_sheet.hpp"
#include "composition/layout.hpp"
#include "scene/description.hpp"
#include "views/budget.hpp"
#include "views/draw_view.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// Composes the views of a sheet, in order, with their annotations and the sheet's furniture. Work for which there is
/// no time is omitted, and noted in the budget. A sheet that leaves out more dimensions than `input` permits is
/// returned unfinished, with `left_out` alone.
FinishedSheet compose(const SheetInput& input, std::vector<ViewResult>& results, const Budget& budget);

}  // namespace epura::pipeline
