// SPDX-License-Identifier: Apache-2.0
// Details on the sheet: their boundaries, and their marks in the views that they enlarge.
#pragma once

#include <span>
#include <vector>

#include "composition/layout.hpp"
#include "views/messages.hpp"

namespace epura::pipeline {

/// Warns of details that are not larger than in the view that they enlarge.
void warn_about_details(const Messages& messages, const SheetOfViews& views, const SheetPlan& plan);

/// Appends the boundaries of the details on a sheet, and their marks in the views that they enlarge, to the layers of
/// all that is drawn there already.
void add_details(std::vector<sheet::Layer>& layers, const SheetInput& input,
                 std::span<const drawing::ViewDrawing> drawings);

}  // namespace epura::pipeline
