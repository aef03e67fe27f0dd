// SPDX-License-Identifier: Apache-2.0
#include "sheet/parts_list.hpp"

#include <algorithm>
#include <cstddef>

#include "base/text.hpp"
#include "sheet/captions.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

constexpr double full_width = 180, row = 6;       // mm
constexpr double text_height = 2.5, padding = 1;  // mm
constexpr double number_width = 14, material_width = 40, mass_width = 24;
constexpr double descent = 0.35;  // of lettering below its base line, in heights

struct Column {
  const char* caption;  ///< key in captions.hpp
  double width;         ///< mm; 0: the rest
  bool is_number;       ///< right-aligned
  std::vector<std::string> texts;
};

// Three significant digits: "0.123 kg", "12.3 kg"; below 0.1 kg in grams.
std::string mass_text(double kilograms, DecimalSign sign) {
  const bool small = kilograms < 0.1;
  return with_decimal_sign(format_rounded(small ? 1000 * kilograms : kilograms, 3), sign) + (small ? " g" : " kg");
}

std::vector<Column> columns_of(const PartsList& list) {
  Column item{"item", number_width, true, {}}, quantity{"quantity", number_width, true, {}};
  Column name{"name", 0, false, {}}, material{"material", material_width, false, {}};
  Column mass{"mass", mass_width, true, {}};
  for (const scene::Item& one : list.items) {
    item.texts.push_back(std::to_string(item.texts.size() + 1));
    quantity.texts.push_back(std::to_string(one.quantity));
    name.texts.push_back(one.name);
    material.texts.push_back(one.material);
    mass.texts.push_back(one.mass ? mass_text(*one.mass, list.sign) : std::string());
  }
  std::vector<Column> columns{item, quantity, name};
  for (const Column& column : {material, mass})
    if (std::any_of(column.texts.begin(), column.texts.end(), [](const std::string& text) { return !text.empty(); }))
      columns.push_back(column);
  return columns;
}

double width_of_rest(const std::vector<Column>& columns, double width) {
  for (const Column& column : columns) width -= column.width;
  return width;
}

/// Writes cells of one row.
class RowWriter {
 public:
  RowWriter(Layer& layer, const Lettering& lettering) : layer_(layer), lettering_(lettering) {}

  // Returns whether the text was cut.
  bool write(const std::string& words, const Rectangle& cell, bool is_number) {
    const FittedText text = fit_text(words, cell.size().x - 2 * padding, text_height, lettering_);
    const double lines = static_cast<double>(text.lines.size());
    const double block = ((lines - 1) * line_spacing + 1) * text.height;
    const double above = (cell.size().y - block - descent * text.height) / 2;
    double base = cell.max.y - above - text.height;
    for (const std::string& line : text.lines) {
      const double x = is_number ? cell.max.x - padding : cell.min.x + padding;
      layer_.texts.push_back({line, {x, base}, text.height, 0, is_number ? Align::right : Align::left, "parts-list"});
      base -= line_spacing * text.height;
    }
    return text.cut;
  }

 private:
  Layer& layer_;
  const Lettering& lettering_;
};

}  // namespace

Rectangle parts_list_box(const std::optional<Rectangle>& title_block, const PartsList& list, const Paper& paper) {
  const Rectangle area = drawing_area(paper);
  const double width = title_block ? title_block->size().x : std::min(full_width, area.size().x);
  const Vec2 corner(area.max.x - width, title_block ? title_block->max.y : area.min.y);
  return {corner, corner + Vec2(width, row * static_cast<double>(list.items.size() + 1))};
}

Rectangle with_parts_list(const std::optional<Rectangle>& title_block, const PartsList& list, const Paper& paper) {
  const Rectangle box = parts_list_box(title_block, list, paper);
  return title_block ? united(*title_block, box) : box;
}

std::vector<std::string> draw_parts_list(Layer& layer, const PartsList& list, const Rectangle& box,
                                         const Lettering& lettering) {
  std::vector<Column> columns = columns_of(list);
  const double rest = width_of_rest(columns, box.size().x);
  for (Column& column : columns)
    if (column.width == 0) column.width = rest;
  layer.strokes.push_back(outline(box));
  const std::size_t count = list.items.size();
  for (std::size_t i = 1; i <= count; ++i) {
    const double y = box.min.y + row * static_cast<double>(i);
    layer.strokes.push_back(line({box.min.x, y}, {box.max.x, y}));
  }
  double left = box.min.x;
  for (std::size_t c = 1; c < columns.size(); ++c) {
    left += columns[c - 1].width;
    layer.strokes.push_back(line({left, box.min.y}, {left, box.max.y}));
  }
  RowWriter writer(layer, lettering);
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i <= count; ++i) {
    const double bottom = box.min.y + row * static_cast<double>(i);
    double x = box.min.x;
    for (const Column& column : columns) {
      const Rectangle cell{{x, bottom}, {x + column.width, bottom + row}};
      const std::string words = i == 0 ? std::string(caption(column.caption, list.language)) : column.texts[i - 1];
      if (writer.write(words, cell, column.is_number))
        warnings.push_back("the parts list has no room for all of '" + words + "'");
      x += column.width;
    }
  }
  return warnings;
}

}  // namespace epura::sheet
