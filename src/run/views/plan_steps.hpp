// SPDX-License-Identifier: Apache-2.0
// Steps of the report that do not belong to a view.
#pragma once

#include <vector>

#include "report/report.hpp"
#include "sheet/sheet.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// Views in, opened plugins out.
report::PlanStep plugins_step(const std::vector<SheetOfViews>& sheets);
/// Texts in and out. Without texts, no font is opened unless `leave_out` is false.
report::PlanStep text_step(const sheet::Sheet& sheet, bool leave_out);

}  // namespace epura::pipeline
