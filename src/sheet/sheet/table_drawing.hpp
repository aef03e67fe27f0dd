// SPDX-License-Identifier: Apache-2.0
// Tables of texts: columns as wide as their texts, with lines between all cells.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sheet/marks.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// What a table says. All rows have the same number of cells.
struct TextTable {
  std::string title{};                ///< above the others; may be empty
  std::vector<std::string> header{};  ///< repeated in each block; may be empty
  std::vector<std::vector<std::string>> rows{};
};

/// The height of this number of rows.
double height_of_rows(std::size_t rows, double text_height);

/// A layer's part for a table: its lines and texts with the upper right corner at `corner`.
class TableDrawing {
 public:
  /// The rows are in `blocks` of equal size side by side; a table with a title has one.
  TableDrawing(TextTable table, int blocks, const DimensionStyle& style);

  [[nodiscard]] Vec2 size() const;
  void draw(Layer& layer, const Vec2& corner, const std::string& role) const;

 private:
  [[nodiscard]] std::size_t rows_of_block() const;
  void draw_row(Layer& layer, const std::vector<std::string>& cells, const std::vector<double>& edges,
                double top) const;

  TextTable table_;
  std::vector<double> widths_;
  int blocks_;
  const DimensionStyle& style_;
};

}  // namespace epura::sheet
