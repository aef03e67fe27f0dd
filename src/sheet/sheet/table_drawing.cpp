// SPDX-License-Identifier: Apache-2.0
#include "sheet/table_drawing.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

constexpr double row_height = 1.8, side = 0.5, base_line = 0.4;  // of the height of capitals
constexpr double between_blocks = 1;                             // likewise

void add_line(Layer& layer, const Vec2& from, const Vec2& to) { layer.strokes.emplace_back().points = {from, to}; }

double sum(const std::vector<double>& widths) {
  double all = 0;
  for (const double one : widths) all += one;
  return all;
}

}  // namespace

TableDrawing::TableDrawing(TextTable table, int blocks, const DimensionStyle& style)
    : table_(std::move(table)), blocks_(blocks), style_(style) {
  widths_.assign(std::max(table_.header.size(), table_.rows.empty() ? 0 : table_.rows.front().size()), 0);
  const auto widen = [this](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      widths_[i] = std::max(widths_[i], style_.width(row[i]) + 2 * side * style_.text);
  };
  widen(table_.header);
  for (const auto& row : table_.rows) widen(row);
  // The last column takes what a long title needs.
  if (const double title = style_.width(table_.title) + 2 * side * style_.text; !table_.title.empty())
    widths_.back() += std::max(title - sum(widths_), 0.0);
}

double height_of_rows(std::size_t rows, double text_height) {
  return static_cast<double>(rows) * row_height * text_height;
}

std::size_t TableDrawing::rows_of_block() const {
  const auto blocks = static_cast<std::size_t>(blocks_);
  return (table_.rows.size() + blocks - 1) / blocks;
}

Vec2 TableDrawing::size() const {
  const std::size_t rows = rows_of_block() + (table_.header.empty() ? 0 : 1) + (table_.title.empty() ? 0 : 1);
  return {blocks_ * sum(widths_) + (blocks_ - 1) * between_blocks * style_.text, height_of_rows(rows, style_.text)};
}

// Texts are in reading order, for programs that extract them. `edges` are the sides of the cells.
void TableDrawing::draw_row(Layer& layer, const std::vector<std::string>& cells, const std::vector<double>& edges,
                            double top) const {
  check(cells.size() < edges.size(), "every cell of a table has a column");
  const double height = row_height * style_.text;
  add_line(layer, {edges.front(), top}, {edges.back(), top});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vec2 at(edges[i] + side * style_.text, top - height + base_line * style_.text);
    if (!cells[i].empty()) layer.texts.push_back({cells[i], at, style_.text, 0, Align::left});
  }
}

void TableDrawing::draw(Layer& layer, const Vec2& corner, const std::string& role) const {
  const double height = row_height * style_.text;
  const std::size_t first_text = layer.texts.size();
  double left = corner.x - size().x;
  for (std::size_t begin = 0; begin < table_.rows.size(); begin += rows_of_block()) {
    const std::size_t end = std::min(begin + rows_of_block(), table_.rows.size());
    std::vector<const std::vector<std::string>*> rows;
    const std::vector<std::string> title{table_.title};
    if (!table_.title.empty()) rows.push_back(&title);
    if (!table_.header.empty()) rows.push_back(&table_.header);
    for (std::size_t i = begin; i < end; ++i) rows.push_back(&table_.rows[i]);
    std::vector<double> edges{left};
    for (const double width : widths_) edges.push_back(edges.back() + width);
    check(edges.size() == widths_.size() + 1, "a table has an edge on both sides of each column");
    const double bottom = corner.y - static_cast<double>(rows.size()) * height;
    // The title is one cell.
    const double below_title = corner.y - (table_.title.empty() ? 0 : height);
    TableObject object{{left, corner.y}, widths_, height, style_.text, side * style_.text};
    object.strokes.begin = layer.strokes.size();
    object.texts.begin = layer.texts.size();
    for (const std::vector<std::string>* row : rows) {
      std::vector<TableCell>& cells = object.rows.emplace_back();
      for (const std::string& words : *row) cells.push_back({words});
    }
    for (const double x : edges)
      add_line(layer, {x, bottom}, {x, x == left || x == edges.back() ? corner.y : below_title});
    for (std::size_t i = 0; i < rows.size(); ++i)
      draw_row(layer, *rows[i], edges, corner.y - static_cast<double>(i) * height);
    add_line(layer, {left, bottom}, {edges.back(), bottom});
    object.strokes.end = layer.strokes.size();
    object.texts.end = layer.texts.size();
    layer.tables.push_back(std::move(object));
    left = edges.back() + between_blocks * style_.text;
  }
  for (std::size_t i = first_text; i < layer.texts.size(); ++i) layer.texts[i].role = role;
}

}  // namespace epura::sheet
