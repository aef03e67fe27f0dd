// SPDX-License-Identifier: Apache-2.0
#include "sheet/sheet_layers.hpp"

#include <utility>

#include "base/error.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/list_table.hpp"

namespace epura::sheet {

BlockBoxes block_boxes(const SheetFurniture& furniture) {
  BlockBoxes boxes;
  if (furniture.title_block) boxes.all = boxes.title_block = title_block_box(*furniture.title_block, furniture.paper);
  const auto add = [&](std::optional<Rectangle>& box, std::size_t rows) {
    box = list_box(boxes.all, rows, furniture.paper);
    boxes.all = with_list(boxes.all, rows, furniture.paper);
  };
  if (furniture.parts_list) add(boxes.parts_list, furniture.parts_list->items.size());
  if (furniture.revisions) add(boxes.revisions, furniture.revisions->rows.size());
  for (const std::optional<Rectangle>& box : {boxes.title_block, boxes.parts_list, boxes.revisions})
    check(!box || (boxes.all && boxes.all->holds(*box, 1e-9)), "the block contains its lists");
  return boxes;
}

FurnitureLayers sheet_layers(const SheetFurniture& furniture, const Lettering& lettering) {
  DrawnTitleBlock block;
  const BlockBoxes boxes = block_boxes(furniture);
  if (furniture.title_block) block = draw_title_block(*furniture.title_block, furniture.paper, lettering);
  Furniture border = frame(furniture.paper, furniture.frame, boxes.title_block);
  append(border.wide, std::move(block.ink.wide));
  append(border.texts, std::move(block.ink.texts));
  append(border.texts, furniture.labels);

  FurnitureLayers result{{}, std::move(block.warnings)};
  const auto add = [&, widths = line_widths(furniture.paper)](scene::SheetLine line,
                                                              std::vector<Stroke> strokes) -> Layer& {
    Layer& layer = result.layers.emplace_back(empty_layer("sheet", line, widths));
    layer.strokes = std::move(strokes);
    return layer;
  };
  add(scene::SheetLine::frame, std::move(border.wide)).fills = std::move(border.fills);
  add(scene::SheetLine::grid, std::move(border.medium));
  add(scene::SheetLine::title_block, std::move(block.ink.medium));
  add(scene::SheetLine::symbol_axes, std::move(block.ink.narrow));
  if (boxes.parts_list)
    append(result.warnings,
           draw_parts_list(add(scene::SheetLine::parts_list, {}), *furniture.parts_list, *boxes.parts_list, lettering));
  if (boxes.revisions)
    append(result.warnings,
           draw_revisions(add(scene::SheetLine::table, {}), *furniture.revisions, *boxes.revisions, lettering));
  add(scene::SheetLine::text, {}).texts = std::move(border.texts);
  std::erase_if(result.layers,
                [](const Layer& layer) { return layer.strokes.empty() && layer.fills.empty() && layer.texts.empty(); });
  return result;
}

}  // namespace epura::sheet
