// SPDX-License-Identifier: Apache-2.0
// Views in their positions -> sheets.
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

/// `results` are the views of the sheet, in their order, with all that belongs to them, and what a sheet has around.
/// What does not fit into the time is omitted, and noted in the budget.
FinishedSheet compose(const SheetInput& input, std::vector<ViewResult>& results, const Budget& budget);

}  // namespace epura::pipeline
