// SPDX-License-Identifier: Apache-2.0
#include "sheet/line_styles.hpp"

#include "base/error.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

double width_of(scene::LineWidth width, const LineWidths& widths) {
  switch (width) {
    case scene::LineWidth::wide:
      return widths.wide;
    case scene::LineWidth::narrow:
      return widths.narrow;
    case scene::LineWidth::frame:
      return wide_line;
    case scene::LineWidth::grid:
      return medium_line;
    case scene::LineWidth::symbol:
      return narrow_line;
  }
  check(false, "a line has a width");
  return 0;
}

}  // namespace

LineWidths line_widths(const Paper& paper) {
  if (paper.width * paper.height >= 841.0 * 594.0) return {0.7, 0.35};
  return {0.5, 0.25};
}

Dashes nominal_dashes(const scene::DashType& type, double width) {
  return {type.dash * width, type.gap * width, type.dot * width, type.dots};
}

LineStyle line_style(scene::SheetLine line, const LineWidths& widths) {
  const scene::SheetLineRow& row = scene::row_of(line);
  const double width = width_of(row.width, widths);
  return {row.name, width, nominal_dashes(row.dashes, width)};
}

Layer empty_layer(const std::string& view, scene::SheetLine line, const LineWidths& widths) {
  return {view + "/" + scene::row_of(line).layer, line_style(line, widths), {}};
}

}  // namespace epura::sheet
