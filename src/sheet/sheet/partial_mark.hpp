// SPDX-License-Identifier: Apache-2.0
// The mark on incomplete drawings.
#pragma once

#include <string>

#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The layer "sheet/partial": "PARTIAL: HIDING LINES" (with the name of the stage that was cut short, of letters and
/// blanks) in the upper margin of the paper, on the left. The letters are strokes, so that no font is needed; their
/// height is 6/10 of the margin, or less if the paper is too narrow.
Layer partial_mark(const Paper& paper, const std::string& stage);

}  // namespace epura::sheet
