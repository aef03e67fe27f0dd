// SPDX-License-Identifier: Apache-2.0
#include "sheet/list_table.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

constexpr double list_width = 180, list_row = 6;       // mm
constexpr double text_height = 2.5, list_padding = 1;  // mm
constexpr double below_base_line = 0.35;               // of lettering below its base line, in heights

// Returns whether the text was cut.
bool write_cell(Layer& layer, const std::string& words, const Rectangle& cell, Align align,
                const Lettering& lettering) {
  const FittedText text = fit_text(words, cell.size().x - 2 * list_padding, text_height, lettering);
  const double lines = static_cast<double>(text.lines.size());
  const double block = ((lines - 1) * line_spacing + 1) * text.height;
  const double above = (cell.size().y - block - below_base_line * text.height) / 2;
  double base = cell.max.y - above - text.height;
  for (const std::string& line : text.lines) {
    const double x = align == Align::right ? cell.max.x - list_padding : cell.min.x + list_padding;
    layer.texts.push_back({line, {x, base}, text.height, 0, align});
    base -= line_spacing * text.height;
  }
  return text.cut;
}

void draw_rules(Layer& layer, const std::vector<ListColumn>& columns, const Rectangle& box) {
  layer.strokes.push_back(outline(box));
  for (std::size_t i = 1; i <= columns.front().texts.size(); ++i) {
    const double y = box.min.y + list_row * static_cast<double>(i);
    layer.strokes.push_back(line({box.min.x, y}, {box.max.x, y}));
  }
  double left = box.min.x;
  for (std::size_t c = 1; c < columns.size(); ++c) {
    left += columns[c - 1].width;
    layer.strokes.push_back(line({left, box.min.y}, {left, box.max.y}));
  }
}

}  // namespace

Rectangle list_box(const std::optional<Rectangle>& below, std::size_t rows, const Paper& paper) {
  const Rectangle area = drawing_area(paper);
  const double width = below ? below->size().x : std::min(list_width, area.size().x);
  const Vec2 corner(below ? below->min.x : area.max.x - width, below ? below->max.y : area.min.y);
  return {corner, corner + Vec2(width, list_row * static_cast<double>(rows + 1))};
}

Rectangle with_list(const std::optional<Rectangle>& below, std::size_t rows, const Paper& paper) {
  const Rectangle box = list_box(below, rows, paper);
  return below ? united(*below, box) : box;
}

std::vector<std::string> draw_list(Layer& layer, std::vector<ListColumn> columns, const Rectangle& box,
                                   const ListNames& names, const Lettering& lettering) {
  double rest = box.size().x;
  for (const ListColumn& column : columns) rest -= column.width;
  for (ListColumn& column : columns)
    if (column.width == 0) column.width = rest;
  for (const ListColumn& column : columns)
    check(column.texts.size() == columns.front().texts.size(), "the columns of a list are equally long");
  TableObject object{{box.min.x, box.max.y}, {}, list_row, text_height, list_padding};
  object.strokes.begin = layer.strokes.size();
  draw_rules(layer, columns, box);
  const std::size_t first = layer.texts.size();
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i <= columns.front().texts.size(); ++i) {
    const double bottom = box.min.y + list_row * static_cast<double>(i);
    double x = box.min.x;
    std::vector<TableCell>& row = *object.rows.emplace(object.rows.begin());
    for (const ListColumn& column : columns) {
      const Rectangle cell{{x, bottom}, {x + column.width, bottom + list_row}};
      const std::string& words = i == 0 ? column.caption : column.texts[i - 1];
      if (write_cell(layer, words, cell, column.is_number ? Align::right : Align::left, lettering))
        warnings.push_back("the " + names.name + " has no room for all of '" + words + "'");
      row.push_back({words, column.is_number});
      x += column.width;
    }
  }
  for (const ListColumn& column : columns) object.widths.push_back(column.width);
  object.strokes.end = layer.strokes.size();
  object.texts = {first, layer.texts.size()};
  layer.tables.push_back(std::move(object));
  for (std::size_t i = first; i < layer.texts.size(); ++i) layer.texts[i].role = names.role;
  return warnings;
}

}  // namespace epura::sheet
