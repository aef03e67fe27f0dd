// SPDX-License-Identifier: Apache-2.0
// What the stages made, in plain values.
#pragma once

#include <epura/epura.hpp>
#include <vector>

#include "drawing/view_drawing.hpp"
#include "report/error_budget.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// `sheet` counts from 1.
DrawnView drawn_view(const drawing::ViewDrawing& drawing, int sheet);

/// Without the term of writing, which depends on the file.
ErrorBudget error_budget(const report::ViewError& error);

std::vector<SheetLayer> layers_of(const sheet::Sheet& sheet);

}  // namespace epura
