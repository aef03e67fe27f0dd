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
};

/// Layers "VIEW/hidden" and, painted over it, "VIEW/visible". The drawing is in its place on `paper`, which has a size.
/// Visible lines are wide and continuous, hidden ones half as wide and dashed (12 widths, gap 3 widths).
Sheet make_sheet(const Drawing& drawing, const Paper& paper, const SheetWish& wish);

}  // namespace epura
