// SPDX-License-Identifier: Apache-2.0
// The layers of a sheet that do not belong to views.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sheet/form.hpp"
#include "sheet/frame.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/parts_list.hpp"
#include "sheet/revision_list.hpp"
#include "sheet/title_block.hpp"

namespace epura::sheet {

struct SheetFurniture {
  Paper paper;  ///< with its final size and the margins of its frame
  FrameKind frame = FrameKind::none;
  std::optional<TitleBlock> title_block{};
  std::vector<Text> labels{};  ///< of views
  Font font{};
  std::optional<PartsList> parts_list{};
  std::optional<RevisionList> revisions{};
  std::shared_ptr<const Form> form{};  ///< instead of the frame and the title block
  std::shared_ptr<const Logo> logo{};
  std::vector<scene::RoleStyle> styles{};
};

/// The rectangles of the title block and of the lists on it, as far as they exist, and of all of them together.
struct BlockBoxes {
  std::optional<Rectangle> title_block{}, parts_list{}, revisions{}, all{};
};
BlockBoxes block_boxes(const SheetFurniture& furniture);

struct FurnitureLayers {
  std::vector<Layer> layers;
  std::vector<std::string> warnings;
};

/// Those of them that are not empty, to be painted in this order:
///   sheet/template      a form; with it, there is nothing else of the frame and the title block
///   sheet/logo          a logo
///   sheet/frame         frame, centring marks, trimming marks, outline of the title block: 0.7 mm
///   sheet/grid          grid references: 0.35 mm
///   sheet/title-block   lines of the title block, outlines of the projection symbol: 0.35 mm
///   sheet/centre-lines  of the projection symbol: 0.18 mm
///   sheet/parts-list    the parts list: 0.35 mm, with its lettering
///   sheet/tables        the list of revisions: 0.35 mm, with its lettering
///   sheet/text          all other lettering
FurnitureLayers sheet_layers(const SheetFurniture& furniture, const Lettering& lettering);

}  // namespace epura::sheet
