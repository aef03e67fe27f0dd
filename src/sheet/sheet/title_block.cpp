// SPDX-License-Identifier: Apache-2.0
#include "sheet/title_block.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/title_fields.hpp"
#include "sheet/captions.hpp"
#include "sheet/fit_text.hpp"

namespace epura::sheet {

namespace {

constexpr double full_width = 180, min_width = 120;
constexpr double block_row = 9;  // mm; a caption, and a value with room for descenders
constexpr double caption_height = 1.8, value_height = 3.5, title_height = 5;
constexpr double block_padding = 1;  // between lines and text
constexpr double caption_space = 3;  // of a cell's height
constexpr double descent = 0.35;     // below the base line, in text heights
constexpr int columns_of_free_fields = 3;

struct Cell {
  std::string name;
  double left, bottom, width, height;  // in a block 180 wide
  double text_height = value_height;
  std::string caption{};  ///< of a field that is not in the standard
};

constexpr double right_part = 57, owner_width = 55;
constexpr double symbol_width = 22, symbol_height = 2.5;

// Adds those cells of a row that have a value or are required, beside each other and as wide together as the room;
// their widths are in proportion.
void add_row(std::vector<Cell>& cells, const std::vector<Cell>& row_of_cells, double left, double width) {
  double sum = 0;
  for (const Cell& cell : row_of_cells) sum += cell.width;
  for (Cell cell : row_of_cells) {
    cell.left = left;
    cell.width *= width / sum;
    left += cell.width;
    cells.push_back(cell);
  }
}

// The layout of the annex of ISO 7200, without optional cells that have no value, and above it data of the drawing
// rather than of the document.
std::vector<Cell> standard_cells(const TitleBlock& block) {
  const auto given = [&block](std::vector<Cell> row_of_cells, std::vector<std::string> required) {
    std::erase_if(row_of_cells, [&](const Cell& cell) {
      return value_of(block, cell.name).empty() &&
             std::find(required.begin(), required.end(), cell.name) == required.end();
    });
    return row_of_cells;
  };
  const double right = full_width - right_part;
  std::vector<Cell> cells{{"owner", 0, 0, owner_width, 3 * block_row},
                          {"title", owner_width, 0, right - owner_width, 2 * block_row, title_height},
                          {"number", right, block_row, right_part, block_row}};
  add_row(cells,
          given({{"revision", 0, 0, 11, block_row},
                 {"date", 0, 0, 24, block_row},
                 {"language", 0, 0, 9, block_row},
                 {"sheet", 0, 0, 13, block_row}},
                {"date", "sheet"}),
          right, right_part);
  add_row(cells,
          given({{"document_type", 0, 2 * block_row, 68, block_row}, {"status", 0, 2 * block_row, 57, block_row}},
                {"document_type"}),
          owner_width, full_width - owner_width);
  add_row(cells,
          {{"creator", 0, 3 * block_row, 58, block_row},
           {"approver", 0, 3 * block_row, 58, block_row},
           {"scale", 0, 3 * block_row, 24, block_row},
           {"size", 0, 3 * block_row, 18, block_row}},
          0, full_width - symbol_width);
  add_row(cells,
          given({{"material", 0, 4 * block_row, 69, block_row},
                 {"mass", 0, 4 * block_row, 28, block_row},
                 {"department", 0, 4 * block_row, 40, block_row},
                 {"technical_reference", 0, 4 * block_row, 43, block_row}},
                {}),
          0, full_width);
  for (const Cell& cell : cells)
    check(cell.width > 0 && cell.left >= 0 && cell.left + cell.width <= full_width * (1 + 1e-9),
          "cells are within the title block");
  return cells;
}

constexpr double height_below_logo = 8;  // of the room for the owner

using Field = std::pair<std::string, std::string>;

/// What a title block shows, wherever it stands.
struct Content {
  std::vector<Cell> cells;  ///< standard ones
  double height = 0;        ///< of these
  std::vector<Field> free;  ///< fields without such a cell, in their order
};

Content content_of(const TitleBlock& block) {
  Content content{standard_cells(block), 0, {}};
  for (const Cell& cell : content.cells) content.height = std::max(content.height, cell.bottom + cell.height);
  for (const Field& field : block.fields) {
    const auto has_name = [&field](const Cell& cell) { return cell.name == field.first; };
    if (field.first != "supplementary_title" && !field.second.empty() &&
        std::none_of(content.cells.begin(), content.cells.end(), has_name))
      content.free.push_back(field);
  }
  return content;
}

double cell_height_of(std::size_t rows) { return block_row * static_cast<double>(rows); }

std::size_t rows_for(std::size_t fields) { return (fields + columns_of_free_fields - 1) / columns_of_free_fields; }

// "surface_treatment" -> "Surface treatment"
std::string caption_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

// Whether the caption of a free cell is one of captions.hpp, in the language of the block.
bool is_named(const std::string& field) {
  const std::vector<scene::TitleField>& named = scene::title_fields();
  return std::any_of(named.begin(), named.end(), [&field](const auto& one) { return one.name == field; });
}

// Above the standard cells, the first at the top; the cells of the last row share its width.
std::vector<Cell> free_cells(const std::vector<Field>& fields, std::size_t rows, double bottom) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < fields.size() && i < rows * columns_of_free_fields; ++i) {
    const std::size_t line = i / columns_of_free_fields, column = i % columns_of_free_fields;
    const std::size_t here = std::min<std::size_t>(columns_of_free_fields, fields.size() - i + column);
    const double width = full_width / static_cast<double>(here);
    cells.push_back({fields[i].first, width * static_cast<double>(column), bottom + cell_height_of(rows - 1 - line),
                     width, block_row, value_height,
                     is_named(fields[i].first) ? std::string() : caption_of(fields[i].first)});
  }
  return cells;
}

/// Draws cells, one after another.
class Writer {
 public:
  Writer(const TitleBlock& block, const Rectangle& box, const Lettering& lettering)
      : block_(block), box_(box), factor_(box.size().x / full_width), lettering_(lettering) {
    drawn_.ink.wide.push_back(outline(box));
  }

  // Draws the left and upper lines: together, those of all cells are all lines inside the block.
  void draw(const Cell& cell) {
    const Rectangle r = rectangle(cell);
    if (cell.left > 0) divide({r.min.x, r.max.y}, r.min);
    if (r.max.y < box_.max.y) divide({r.min.x, r.max.y}, r.max);
    const double width = r.size().x - 2 * block_padding;
    const std::string words =
        cell.caption.empty() ? std::string(caption(cell.name, value_of(block_, "language"))) : cell.caption;
    write(fit_text(words, width, caption_height, lettering_), r.min.x + block_padding,
          r.max.y - block_padding - caption_height, "caption");
    std::vector<FittedText> texts = {cell.name == "number" ? whole_number(width, r.size().y - caption_space)
                                                           : fitted(cell.name, width, height_in(cell))};
    if (cell.name == "title") texts.push_back(fitted("supplementary_title", width, value_height));
    const bool below_logo = cell.name == "owner" && block_.has_logo;
    const double top = below_logo ? r.min.y + height_below_logo : r.max.y - caption_space;
    write_values(texts, {r.min, {r.max.x, top}}, cell.name == "title" ? "title" : "field");
  }

  void draw_symbol() {
    const Rectangle r = rectangle({"", full_width - symbol_width, 3 * block_row, symbol_width, block_row});
    divide({r.min.x, r.max.y}, r.min);
    if (r.max.y < box_.max.y) divide({r.min.x, r.max.y}, r.max);
    if (!block_.angle) return;
    Furniture symbol = projection_symbol(*block_.angle, symbol_height, r.centre());
    append(drawn_.ink.medium, std::move(symbol.medium));
    append(drawn_.ink.narrow, std::move(symbol.narrow));
  }

  void leave_out(std::size_t fields) {
    if (fields > 0)
      drawn_.warnings.push_back("the title block has no room for the last " + std::to_string(fields) +
                                " of its fields");
  }

  DrawnTitleBlock result() { return std::move(drawn_); }

 private:
  [[nodiscard]] Rectangle rectangle(const Cell& cell) const {
    const Vec2 corner = box_.min + Vec2(cell.left * factor_, cell.bottom);
    return {corner, corner + Vec2(cell.width * factor_, cell.height)};
  }

  void divide(const Vec2& from, const Vec2& to) { drawn_.ink.medium.push_back(line(from, to)); }

  FittedText fitted(const std::string& name, double width, double height) {
    FittedText text = fit_text(value_of(block_, name), width, height, lettering_);
    if (text.cut) drawn_.warnings.push_back("the title block has no room for all of the text of '" + name + "'");
    return text;
  }

  // Marks above capitals, as of "Ž", would touch the caption above a text of the usual height.
  [[nodiscard]] double height_in(const Cell& cell) const {
    constexpr double smaller = 2.5, most = 1.11;  // mm; of the height of capitals
    if (cell.height > block_row) return cell.text_height;
    double top = 0;
    for (const GlyphOutline& outline : lettering_.outlines(value_of(block_, cell.name), 1))
      for (const GlyphOutline::Curve& curve : outline.curves) top = std::max(top, curve.end.y);
    return top > most ? smaller : cell.text_height;
  }

  // A drawing is found by its number: all of it is written. ISO 7200.
  FittedText whole_number(double width, double height) {
    FittedText text = fit_whole_text(value_of(block_, "number"), {width, height}, value_height, lettering_);
    if (text.height < min_text_height)
      drawn_.warnings.push_back("the identification number needs letters of " + format_fixed(text.height, 1) +
                                " mm, smaller than those of ISO 3098\n  hint: shorten it");
    return text;
  }

  void write(const FittedText& text, double left, double base_line, const std::string& role) {
    for (const std::string& words : text.lines) {
      drawn_.ink.texts.push_back({words, {left, base_line}, text.height, 0, Align::left, role});
      base_line -= line_spacing * text.height;
    }
  }

  // Below each other, and together centred in the height of the room.
  void write_values(const std::vector<FittedText>& texts, const Rectangle& room, const std::string& role) {
    double height = 0;
    for (const FittedText& text : texts) height += line_spacing * text.height * static_cast<double>(text.lines.size());
    double top = room.centre().y + height / 2;
    for (const FittedText& text : texts) {
      const double above = (line_spacing - 1 - descent) * text.height;
      write(text, room.min.x + block_padding, top - above - text.height, role);
      top -= line_spacing * text.height * static_cast<double>(text.lines.size());
    }
  }

  const TitleBlock& block_;
  Rectangle box_;
  double factor_;
  const Lettering& lettering_;
  DrawnTitleBlock drawn_;
};

std::optional<Rectangle> box_of_cell(const Content& content, const Paper& paper) {
  const Rectangle area = drawing_area(paper);
  const double width = std::min(full_width, area.size().x), max_height = area.size().y / 2;
  if (width < min_width || content.height > max_height) return std::nullopt;
  const auto max_rows = static_cast<std::size_t>((max_height - content.height) / block_row);
  const std::size_t rows = std::min(rows_for(content.free.size()), max_rows);
  const Vec2 corner(area.max.x - width, area.min.y);
  return Rectangle{corner, corner + Vec2(width, content.height + cell_height_of(rows))};
}

}  // namespace

std::string value_of(const TitleBlock& block, const std::string& name) {
  for (const auto& [field, value] : block.fields)
    if (field == name && !value.empty()) return value;
  if (name == "scale") return block.scale;
  if (name == "size") return block.size;
  if (name == "sheet") return std::to_string(block.sheet) + "/" + std::to_string(block.sheets);
  if (name == "page_number") return std::to_string(block.sheet);
  if (name == "page_count") return std::to_string(block.sheets);
  return {};
}

std::optional<Rectangle> title_block_box(const TitleBlock& block, const Paper& paper) {
  return block.place ? block.place : box_of_cell(content_of(block), paper);
}

Rectangle logo_box(const Rectangle& title_block) {
  const double width = owner_width * title_block.size().x / full_width;
  const Vec2 corner = title_block.min + Vec2(block_padding, height_below_logo);
  return {corner, title_block.min + Vec2(width - block_padding, 3 * block_row - caption_space)};
}

DrawnTitleBlock draw_title_block(const TitleBlock& block, const Paper& paper, const Lettering& lettering) {
  const Content content = content_of(block);
  const auto box = block.place ? block.place : box_of_cell(content, paper);
  if (!box)
    return {{},
            {"the sheet is too small for a title block\n  hint: choose a size such as A4, or leave it out with "
             "frame plain"}};
  const auto rows = static_cast<std::size_t>((box->size().y - content.height) / block_row + 0.5);
  const std::vector<Cell> free = free_cells(content.free, rows, content.height);
  check(free.size() <= content.free.size(), "every field has one cell");
  Writer writer(block, *box, lettering);
  for (const Cell& cell : content.cells) writer.draw(cell);
  writer.draw_symbol();
  for (const Cell& cell : free) writer.draw(cell);
  writer.leave_out(content.free.size() - free.size());
  return writer.result();
}

}  // namespace epura::sheet
