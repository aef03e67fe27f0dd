// The word that marks a drawing which lacks lines.
#pragma once

#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// "PARTIAL" in the upper margin of the paper, at its left: the layer "sheet/partial". The letters are strokes, so that
/// no font is needed; they are as high as 6/10 of the margin, smaller where the paper is too narrow for them.
Layer partial_mark(const Paper& paper);

}  // namespace epura
