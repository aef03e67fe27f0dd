// SPDX-License-Identifier: Apache-2.0
// Lists that stand on the title block, one on the other, to be read upwards: parts, revisions. ISO 7200, ISO 7573.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sheet/lettering.hpp"
#include "sheet/paper.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

struct ListColumn {
  std::string caption;
  double width;                    ///< mm; 0: the rest
  bool is_number;                  ///< right-aligned
  std::vector<std::string> texts;  ///< from the first row above the captions
};

/// The rectangle of a list with so many rows and captions on what is below it and as wide, or in the lower right corner
/// of the drawing area if there is nothing. It may be higher than the area.
Rectangle list_box(const std::optional<Rectangle>& below, std::size_t rows, const Paper& paper);

/// The rectangle of both.
Rectangle with_list(const std::optional<Rectangle>& below, std::size_t rows, const Paper& paper);

/// Adds lines, and texts of this role, with captions at the bottom. Returns warnings about texts that were cut, in
/// which the list is called `name`.
struct ListNames {
  std::string role, name;
};
std::vector<std::string> draw_list(Layer& layer, std::vector<ListColumn> columns, const Rectangle& box,
                                   const ListNames& names, const Lettering& lettering);

}  // namespace epura::sheet
