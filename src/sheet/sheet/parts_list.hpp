// SPDX-License-Identifier: Apache-2.0
// The list of the parts on a sheet. ISO 7573.
#pragma once

#include <string>
#include <vector>

#include "sheet/lettering.hpp"
#include "sheet/notation.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"
#include "world/items.hpp"

namespace epura::sheet {

struct PartsList {
  std::vector<world::Item> items;
  std::string language{};  ///< of the captions
  DecimalSign sign = DecimalSign::point;
};

/// Adds lines and texts: captions at the bottom and the items above them, to be read upwards. Materials and masses have
/// columns if some item has one. Returns warnings about texts that were cut.
std::vector<std::string> draw_parts_list(Layer& layer, const PartsList& list, const Rectangle& box,
                                         const Lettering& lettering);

}  // namespace epura::sheet
