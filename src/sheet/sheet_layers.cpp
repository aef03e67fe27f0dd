// SPDX-License-Identifier: Apache-2.0
#include "sheet/sheet_layers.hpp"

#include <utility>

#include "sheet/line_styles.hpp"

namespace epura::sheet {

std::optional<Rectangle> parts_list_box(const SheetFurniture& furniture) {
  if (!furniture.parts_list) return std::nullopt;
  std::optional<Rectangle> block;
  if (furniture.title_block) block = title_block_box(*furniture.title_block, furniture.paper);
  return parts_list_box(block, *furniture.parts_list, furniture.paper);
}

FurnitureLayers sheet_layers(const SheetFurniture& furniture, const Lettering& lettering) {
  DrawnTitleBlock block;
  std::optional<Rectangle> box;
  if (furniture.title_block) {
    block = draw_title_block(*furniture.title_block, furniture.paper, lettering);
    box = title_block_box(*furniture.title_block, furniture.paper);
  }
  Furniture border = frame(furniture.paper, furniture.frame, box);
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
  if (const auto list = parts_list_box(furniture)) {
    Layer& layer = add(scene::SheetLine::parts_list, {});
    std::vector<std::string> more = draw_parts_list(layer, *furniture.parts_list, *list, lettering);
    append(result.warnings, std::move(more));
  }
  add(scene::SheetLine::text, {}).texts = std::move(border.texts);
  std::erase_if(result.layers,
                [](const Layer& layer) { return layer.strokes.empty() && layer.fills.empty() && layer.texts.empty(); });
  return result;
}

}  // namespace epura::sheet
