// SPDX-License-Identifier: Apache-2.0
// Moves labels of views off lines, dimensions and other texts.
#pragma once

#include <optional>
#include <string>

#include "sheet/lettering.hpp"
#include "sheet/notation.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Moves the labels of views (role "label" in layer "sheet/text") that touch a line, an area or another text, or stand
/// between their view and its dimension above: upwards, and if that does not help to either side. Labels without a
/// free position in `area` nearby stay.
void clear_labels(Sheet& sheet, const Rectangle& area, const Lettering& lettering);

/// The text above a view: its label, and its scale if that differs from the sheet's: "A-A", "A-A (2:1)", "(1:2)". Views
/// without a scale, such as perspectives, have no `scale`. A scale that is not a simple ratio is not written.
std::string view_label(const std::string& label, std::optional<double> scale, double main_scale,
                       DecimalSign sign = DecimalSign::point);

/// The label above the middle of the view's ink, 5 mm high.
Text label_above(const std::string& label, const Rectangle& ink);

}  // namespace epura::sheet
