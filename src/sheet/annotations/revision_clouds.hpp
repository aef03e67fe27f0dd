// SPDX-License-Identifier: Apache-2.0
// Clouds round what a revision changed, each with the index of the revision in a triangle. ASME Y14.35, 7.3; ISO 7200
// leaves the mark open.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sheet/line_styles.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Boxes with little between them become one.
std::vector<Rectangle> united_changes(std::vector<Rectangle> boxes);

/// Layer "sheet/clouds" round boxes of ink.
Layer revision_clouds(std::span<const Rectangle> boxes, const std::string& revision, const LineWidths& widths);

}  // namespace epura::sheet
