// SPDX-License-Identifier: Apache-2.0
// The mark on incomplete drawings.
#pragma once

#include <string>

#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// "PARTIAL: HIDING LINES" for the stage that was cut, of letters and blanks, in the upper margin of the paper, at its
/// left: the layer "sheet/partial". The letters are strokes, so that no font is needed; they are as high as 6/10 of the
/// margin, smaller where the paper is too narrow for them.
Layer partial_mark(const Paper& paper, const std::string& stage);

}  // namespace epura::sheet
