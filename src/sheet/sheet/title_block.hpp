// SPDX-License-Identifier: Apache-2.0
// The title block of a sheet. ISO 7200.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sheet/furniture.hpp"
#include "sheet/lettering.hpp"
#include "sheet/paper.hpp"
#include "sheet/projection_symbol.hpp"

namespace epura::sheet {

/// Content of a title block. Nothing is made up: a required cell without a value has only its caption, and optional
/// fields without values have no cells.
struct TitleBlock {
  /// Names as in scene/title_fields.hpp; fields with other names go to separate rows, with their names as captions.
  std::vector<std::pair<std::string, std::string>> fields;
  std::string scale{};                        ///< "1:2"
  std::string size{};                         ///< "A3"
  int sheet = 1, sheets = 1;                  ///< sheet 1 of 1
  std::optional<ProjectionAngle> angle = {};  ///< nothing: no symbol
  std::optional<Rectangle> place = {};        ///< of a form, which is drawn instead
  bool has_logo = false;                      ///< room for it is kept above the owner
};

/// The value of a field; of scale, size and sheet, too. Empty if there is none.
std::string value_of(const TitleBlock& block, const std::string& name);

struct DrawnTitleBlock {
  Furniture ink;
  std::vector<std::string> warnings;  ///< what was cut or omitted
};

/// The rectangle of the title block: in the lower right corner of the drawing area, 180 mm wide, or as wide as the area
/// if that is narrower. Nothing if it would take up more than half of the area's height, or be less than 120 mm wide.
/// It depends on which fields have values but not on these, so it is known before the scale is.
std::optional<Rectangle> title_block_box(const TitleBlock& block, const Paper& paper);

/// The room for a logo in the cell of the owner of a title block in this rectangle.
Rectangle logo_box(const Rectangle& title_block);

/// Lines, captions and values. Long values are fitted by fit_text.
DrawnTitleBlock draw_title_block(const TitleBlock& block, const Paper& paper, const Lettering& lettering);

}  // namespace epura::sheet
