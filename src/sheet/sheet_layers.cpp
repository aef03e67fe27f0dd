// SPDX-License-Identifier: Apache-2.0
#include "sheet/sheet_layers.hpp"

#include <utility>

namespace epura {

namespace {

void add(std::vector<Layer>& layers, Layer layer) {
  if (!layer.strokes.empty() || !layer.fills.empty() || !layer.texts.empty()) layers.push_back(std::move(layer));
}

}  // namespace

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
  add(result.layers, {"sheet/frame", {"frame", wide_line}, std::move(border.wide), std::move(border.fills)});
  add(result.layers, {"sheet/grid", {"grid", medium_line}, std::move(border.medium)});
  add(result.layers, {"sheet/title-block", {"title-block", medium_line}, std::move(block.ink.medium)});
  add(result.layers, {"sheet/centre-lines", {"centre-lines", narrow_line}, std::move(block.ink.narrow)});
  add(result.layers, {"sheet/text", {"text", medium_line}, {}, {}, std::move(border.texts)});
  return result;
}

}  // namespace epura
