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

/// Name of the style of dimensions with the sizes of tolerance frames.
inline constexpr const char* dxf_frame_style = "FRAMES";

/// What a block has: a part of the drawing that other programs move as a whole, the ink of an entity, an arrowhead.
enum class DxfBlockKind { view, dimension, table, arrowhead };

struct DxfBlock {
  std::string name;  ///< see dxf_names
  Vec2 place;        ///< where its origin stands on the sheet, mm
  DxfBlockKind kind = DxfBlockKind::view;
};

/// Handles of what entities refer to.
struct DxfHandles {
  int leader_style = 0, table_style = 0;  ///< objects after the entities; 0 if there are none
  int text_style = 0;
  int model_space = 0;  ///< which owns all entities outside blocks
  int first_block = 0;  ///< of the blocks of the file, which follow each other

  [[nodiscard]] int block(std::size_t number) const { return first_block + static_cast<int>(number); }
};

/// Adds everything before the entities except the header, which is written last because it has the number of handles.
/// `layers` are the names of the sheet's layers in the file. `add_entities` is called with the number of each block and
/// the handle that owns its entities, when `handles` are complete.
struct DxfParts {
  const sheet::Sheet& sheet;
  const std::vector<std::string>& layers;
  const std::vector<DxfBlock>& blocks;
  double frame_text;  ///< height of texts in tolerance frames that are entities, mm; 0 if there are none
};
void add_dxf_tables(DxfWriter& dxf, const DxfParts& parts, DxfHandles& handles,
                    const std::function<void(std::size_t block, int owner)>& add_entities);

/// Comments with the title, and the header of a file with this number of handles: millimetres, line type scale 1.
std::string dxf_header(const sheet::Sheet& sheet, const std::vector<DxfBlock>& blocks, int handles, DxfVersion version);

}  // namespace epura::output
