// SPDX-License-Identifier: Apache-2.0
// Everything in a DXF file except its entities.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "output/dxf_writer.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// Name of the text style with the font of the sheet. LibreCAD ignores the font, and letters texts in its own font of
/// this name, which has most characters.
inline constexpr const char* dxf_text_style = "UNICODE";

/// Name of the style of dimensions that say so many times their length in the file. Styles have the sizes that
/// dimensions have on the sheet.
std::string dxf_dimension_style(double factor);

/// A block with entities: a part of the drawing that other programs move as a whole.
struct DxfBlock {
  std::string name;           ///< see dxf_names
  Vec2 place;                 ///< where its origin stands on the sheet, mm
  bool is_dimension = false;  ///< it has the ink of a dimension
};

/// Adds everything before the entities except the header, which is written last because it has the number of handles.
/// `layers` are the names of the sheet's layers in the file. `add_entities` is called with the number of each block and
/// the handle that owns its entities. Returns the handle of the model space, which owns all other entities.
int add_dxf_tables(DxfWriter& dxf, const sheet::Sheet& sheet, const std::vector<std::string>& layers,
                   const std::vector<DxfBlock>& blocks,
                   const std::function<void(std::size_t block, int owner)>& add_entities);

/// Adds the sections after the entities.
void add_dxf_objects(DxfWriter& dxf);

/// Comments with the title, and the header of a file with this number of handles: millimetres, line type scale 1.
std::string dxf_header(const sheet::Sheet& sheet, const std::vector<DxfBlock>& blocks, int handles, DxfVersion version);

}  // namespace epura::output
