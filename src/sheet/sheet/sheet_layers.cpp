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

namespace {

// A form without a place for it has no logo.
std::vector<Layer> logo_layers(const SheetFurniture& furniture, const BlockBoxes& boxes) {
  if (!furniture.logo) return {};
  if (furniture.form)
    return furniture.form->logo ? draw_logo(*furniture.logo, *furniture.form->logo) : std::vector<Layer>();
  return boxes.title_block ? draw_logo(*furniture.logo, logo_box(*boxes.title_block)) : std::vector<Layer>();
}

// Adds a form, or returns the frame and the title block.
Furniture border_of(FurnitureLayers& result, const SheetFurniture& furniture, const BlockBoxes& boxes,
                    const Lettering& lettering) {
  if (furniture.form && furniture.title_block) {
    DrawnForm drawn = draw_form(*furniture.form, *furniture.title_block, lettering);
    result.layers = std::move(drawn.layers);
    result.warnings = std::move(drawn.warnings);
    return {};
  }
  Furniture border = frame(furniture.paper, furniture.frame, boxes.title_block);
  if (!furniture.title_block) return border;
  DrawnTitleBlock block = draw_title_block(*furniture.title_block, furniture.paper, lettering);
  result.warnings = std::move(block.warnings);
  append(border.wide, std::move(block.ink.wide));
  append(border.texts, std::move(block.ink.texts));
  append(border.block, std::move(block.ink.medium));
  append(border.narrow, std::move(block.ink.narrow));
  return border;
}

}  // namespace

FurnitureLayers sheet_layers(const SheetFurniture& furniture, const Lettering& lettering) {
  const BlockBoxes boxes = block_boxes(furniture);
  FurnitureLayers result;
  Furniture border = border_of(result, furniture, boxes, lettering);
  append(result.layers, logo_layers(furniture, boxes));
  append(border.texts, furniture.labels);

  const auto add = [&, widths = line_widths(furniture.paper, furniture.styles)](scene::SheetLine line,
                                                                                std::vector<Stroke> strokes) -> Layer& {
    Layer& layer = result.layers.emplace_back(empty_layer("sheet", line, widths));
    layer.strokes = std::move(strokes);
    return layer;
  };
  add(scene::SheetLine::frame, std::move(border.wide)).fills = std::move(border.fills);
  add(scene::SheetLine::grid, std::move(border.medium));
  add(scene::SheetLine::title_block, std::move(border.block));
  add(scene::SheetLine::symbol_axes, std::move(border.narrow));
  if (boxes.parts_list)
    append(result.warnings,
           draw_parts_list(add(scene::SheetLine::parts_list, {}), *furniture.parts_list, *boxes.parts_list, lettering));
  if (boxes.revisions)
    append(result.warnings,
           draw_revisions(add(scene::SheetLine::table, {}), *furniture.revisions, *boxes.revisions, lettering));
  add(scene::SheetLine::text, {}).texts = std::move(border.texts);
  std::erase_if(result.layers, [](const Layer& layer) {
    return layer.strokes.empty() && layer.fills.empty() && layer.texts.empty() && layer.pictures.empty();
  });
  return result;
}

}  // namespace epura::sheet
