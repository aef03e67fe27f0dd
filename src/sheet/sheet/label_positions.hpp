// SPDX-License-Identifier: Apache-2.0
// Labels of views.
#pragma once

#include <optional>
#include <string>

#include "sheet/lettering.hpp"
#include "sheet/notation.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The text above a view: its label, and its scale if that differs from the sheet's: "A-A", "A-A (2:1)", "(1:2)". Views
/// without a scale, such as perspectives, have no `scale`. A scale that is not a simple ratio is not written.
std::string view_label(const std::string& label, std::optional<double> scale, double main_scale,
                       DecimalSign sign = DecimalSign::point);

/// The label above the middle of the view's ink, 5 mm high.
Text label_above(const std::string& label, const Rectangle& ink);

}  // namespace epura::sheet
