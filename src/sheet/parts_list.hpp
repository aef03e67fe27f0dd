// SPDX-License-Identifier: Apache-2.0
// The list of the parts on a sheet. ISO 7573.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/items.hpp"
#include "sheet/lettering.hpp"
#include "sheet/notation.hpp"
#include "sheet/paper.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

struct PartsList {
  std::vector<scene::Item> items;
  std::string language{};  ///< of the captions
  DecimalSign sign = DecimalSign::point;
};

/// The rectangle of the list above the title block and as wide, or in the lower right corner of the drawing area if
/// there is none. It may be higher than the area.
Rectangle parts_list_box(const std::optional<Rectangle>& title_block, const PartsList& list, const Paper& paper);

/// The rectangle of both.
Rectangle with_parts_list(const std::optional<Rectangle>& title_block, const PartsList& list, const Paper& paper);

/// Adds lines and texts: captions at the bottom and the items above them, to be read upwards. Materials and masses have
/// columns if some item has one. Returns warnings about texts that were cut.
std::vector<std::string> draw_parts_list(Layer& layer, const PartsList& list, const Rectangle& box,
                                         const Lettering& lettering);

}  // namespace epura::sheet
