// SPDX-License-Identifier: Apache-2.0
// Moves labels of views off lines, dimensions and other texts.
#pragma once

#include "sheet/lettering.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Moves the labels of views (role "label" in layer "sheet/text") that touch a line, an area or another text, or stand
/// between their view and its dimension above: upwards, and if that does not help to either side. Labels stay in
/// `area`; where nothing is free, they stay where they are.
void clear_labels(Sheet& sheet, const Rectangle& area, const Lettering& lettering);

}  // namespace epura::sheet
