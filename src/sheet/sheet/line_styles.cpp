// SPDX-License-Identifier: Apache-2.0
#include "sheet/line_styles.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "sheet/dash.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

double width_of_kind(scene::LineWidth width, const LineWidths& widths) {
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

// What a style file says of a role; nothing if it does not name it.
scene::RoleStyle given_style(scene::SheetLine line, const LineWidths& widths) {
  for (const scene::RoleStyle& style : widths.styles)
    if (style.line == line) return style;
  return {line};
}

// Edges have been fitted already, so that they have ink where others cross them.
void set_dashes(Layer& layer, const scene::DashType& type) {
  layer.style.dashes = nominal_dashes(type, layer.style.width);
  for (Stroke& stroke : layer.strokes) {
    if (stroke.kind) continue;
    stroke.pattern.clear();
    const double length = length_of(stroke.points, stroke.closed, stroke.curves);
    stroke.dashes = !type.is_broken() ? Dashes()
                    : stroke.closed   ? fit_closed(length, layer.style.width, type)
                                      : fit_open(length, layer.style.width, type);
  }
}

}  // namespace

LineWidths line_widths(const Paper& paper, std::vector<scene::RoleStyle> styles) {
  if (paper.width * paper.height >= 841.0 * 594.0) return {0.7, 0.35, std::move(styles)};
  return {0.5, 0.25, std::move(styles)};
}

scene::DashType dash_type(scene::SheetLine line, const LineWidths& widths) {
  return given_style(line, widths).dashes.value_or(scene::row_of(line).dashes);
}

Dashes nominal_dashes(const scene::DashType& type, double width) {
  return {type.dash * width, type.gap * width, type.dot * width, type.dots};
}

double line_width(scene::SheetLine line, const LineWidths& widths) {
  return given_style(line, widths).width.value_or(width_of_kind(scene::row_of(line).width, widths));
}

LineStyle line_style(scene::SheetLine line, const LineWidths& widths) {
  const double width = line_width(line, widths);
  return {scene::row_of(line).name, width, nominal_dashes(dash_type(line, widths), width),
          given_style(line, widths).colour.value_or(Colour())};
}

void restyle(std::vector<Layer>& layers, const LineWidths& widths) {
  for (Layer& layer : layers) {
    const auto row = std::find_if(scene::sheet_lines.begin(), scene::sheet_lines.end(),
                                  [&](const scene::SheetLineRow& one) { return one.name == layer.style.name; });
    if (row == scene::sheet_lines.end()) continue;
    const scene::RoleStyle given = given_style(row->line, widths);
    layer.style.width = given.width.value_or(layer.style.width);
    if (layer.style.colour == Colour{}) layer.style.colour = given.colour.value_or(Colour());
    if (given.dashes) set_dashes(layer, *given.dashes);
  }
}

Layer empty_layer(const std::string& view, scene::SheetLine line, const LineWidths& widths) {
  return {view + "/" + scene::row_of(line).layer, line_style(line, widths), {}};
}

}  // namespace epura::sheet
