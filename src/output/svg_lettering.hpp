// SPDX-License-Identifier: Apache-2.0
// Filled areas and texts of an SVG layer.
#pragma once

#include <string>

#include "output/write.hpp"
#include "sheet/lettering.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Rules of the style sheet for what append_fills and append_texts write; empty when the sheet has neither.
std::string lettering_style(const Sheet& sheet);

/// Appends a line for each area, in a group. `height` of the sheet in mm: SVG has y down.
void append_fills(std::string& svg, const Layer& layer, double height);

/// Appends a line for each text, in a group. Outlines have their text as `aria-label`.
void append_texts(std::string& svg, const Layer& layer, double height, const Lettering& lettering, SvgText how);

}  // namespace epura
