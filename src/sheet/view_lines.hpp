// A drawing becomes layers of strokes with line types and widths. Lines: ISO 128-2.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura {

enum class HiddenLines { none, dashed, solid };

/// "none", "dashed" or "solid". Throws Error{input}.
HiddenLines parse_hidden_lines(std::string_view text, const std::string& where = "--hidden");

/// Widths of lines on a sheet, mm: 0.7 and 0.35 from A1 on, 0.5 and 0.25 below.
struct LineWidths {
  double wide, narrow;
};
LineWidths line_widths(const Paper& paper);

/// Layers "VIEW/hidden" and, to be painted over it, "VIEW/visible", of a drawing that is in its place. Visible lines
/// are wide and continuous, hidden ones narrow and dashed (12 widths, gap 3 widths).
std::vector<Layer> view_layers(const Drawing& drawing, const LineWidths& widths, HiddenLines hidden);

}  // namespace epura
