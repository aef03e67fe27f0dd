// A drawing becomes layers of strokes with line types and widths. Lines: ISO 128-2.
#pragma once

#include <string>
#include <string_view>

#include "drawing/drawing.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura {

enum class HiddenLines { none, dashed, solid };

/// "none", "dashed" or "solid". Throws Error{input}.
HiddenLines parse_hidden_lines(std::string_view text);

struct SheetWish {
  HiddenLines hidden = HiddenLines::dashed;
  std::string title;
  bool partial = false;  ///< edges are left out for want of time: the sheet is marked
};

/// Layers "VIEW/hidden" and, painted over it, "VIEW/visible". The drawing is in its place on `paper`, which has a size.
/// A partial drawing gets the layer "sheet/partial" (partial_mark.hpp). Visible lines are wide and continuous, hidden
/// ones half as wide and dashed (12 widths, gap 3 widths).
Sheet make_sheet(const Drawing& drawing, const Paper& paper, const SheetWish& wish);

}  // namespace epura
