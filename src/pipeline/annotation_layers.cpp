// SPDX-License-Identifier: Apache-2.0
#include "pipeline/annotation_layers.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "sheet/cutting_plane_line.hpp"
#include "sheet/dimensions/dimensions.hpp"
#include "sheet/frame.hpp"

namespace epura::pipeline {

namespace {

// A drawing that lacks lines may lack its ends, so its overall dimensions are omitted.
std::vector<scene::DimensionDescription> dimensions_of(const Annotations& annotations, const ViewResult& view) {
  std::vector<scene::DimensionDescription> dimensions = annotations.dimensions;
  if (!view.partial.stages.empty())
    std::erase_if(dimensions, [](const auto& one) { return one.type.value == DimensionType::overall; });
  return dimensions;
}

// Sorted by the names of their sections.
std::vector<sheet::Layer> marks_of(std::span<const Annotations> annotations, std::span<const ViewResult> views,
                                   const sheet::LineWidths& widths) {
  std::map<std::string, sheet::Layer> by_name;
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const scene::CuttingPlane& plane : annotations[i].planes)
      if (auto mark = sheet::cutting_plane_line(views[i].drawing, plane, widths))
        by_name.emplace(plane.name, std::move(*mark));
  std::vector<sheet::Layer> marks;
  for (auto& [name, mark] : by_name) marks.push_back(std::move(mark));
  return marks;
}

void add_boxes(std::vector<sheet::TurnedBox>& boxes, const sheet::Layer& layer, const sheet::Lettering& lettering) {
  const std::vector<sheet::TurnedBox> more = sheet::boxes_of(layer, lettering);
  boxes.insert(boxes.end(), more.begin(), more.end());
}

// Objects on the sheet apart from the views.
sheet::Neighbours neighbours_of(const sheet::SheetFurniture& furniture, const std::vector<sheet::Text>& labels,
                                const std::vector<sheet::Layer>& marks, const sheet::Lettering& lettering) {
  const sheet::Paper& paper = furniture.paper;
  sheet::Neighbours neighbours;
  neighbours.paper = furniture.frame == FrameKind::none ? sheet::Rectangle{{0, 0}, {paper.width, paper.height}}
                                                        : sheet::drawing_area(paper);
  if (furniture.title_block)
    if (const auto box = sheet::title_block_box(*furniture.title_block, paper))
      neighbours.boxes.push_back(sheet::turned_box(*box));
  for (const sheet::Text& label : labels) neighbours.boxes.push_back(sheet::box_of(label, lettering));
  for (const sheet::Layer& mark : marks) add_boxes(neighbours.boxes, mark, lettering);
  return neighbours;
}

sheet::Neighbours with_other_views(sheet::Neighbours neighbours, std::span<const ViewResult> views, std::size_t view) {
  for (std::size_t i = 0; i < views.size(); ++i)
    if (i != view) neighbours.boxes.push_back(sheet::turned_box({views[i].drawing.min, views[i].drawing.max}));
  return neighbours;
}

sheet::Notation notation_of(const SheetInput& input) {
  const scene::SheetDescription& sheet = input.scene.sheets[static_cast<std::size_t>(input.views.sheet)];
  const Vec3 size = input.world.box.max - input.world.box.min;
  const Unit unit = sheet.dimension_unit.value_or(Unit::mm);
  const int usual = sheet::usual_decimals(std::max({size.x, size.y, size.z}), unit);
  return {sheet.decimals.value_or(usual), unit, sheet.decimal_sign.value_or(DecimalSign::point)};
}

}  // namespace

AnnotationLayers annotation_layers(const SheetInput& input, std::span<const ViewResult> views,
                                   const std::vector<sheet::Text>& labels, const Budget& budget) {
  const sheet::SheetFurniture& furniture = input.plan.furniture;
  const sheet::Paper& paper = furniture.paper;
  const sheet::LineWidths widths = sheet::line_widths(paper);
  AnnotationLayers result;
  std::vector<sheet::Layer> marks = marks_of(input.annotations, views, widths);
  std::optional<sheet::Lettering> lettering;
  sheet::Neighbours around;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::vector<scene::DimensionDescription> dimensions = dimensions_of(input.annotations[i], views[i]);
    if (dimensions.empty()) continue;
    if (!lettering) around = neighbours_of(furniture, labels, marks, lettering.emplace());
    const sheet::DimensionStyle style{*lettering, widths.narrow, dimension_text_height(paper, views.size()),
                                      notation_of(input)};
    const drawing::ViewDrawing& drawing = views[i].drawing;
    sheet::Layer layer =
        sheet::dimension_layer({input.world, drawing, dimensions}, style, with_other_views(around, views, i),
                               budget.run.with_part_of_the_time(0.5));
    if (const std::size_t left_out = dimensions.size() - layer.texts.size(); left_out > 0) {
      budget.partial.add_stage("placing dimensions");
      budget.partial.undrawn += static_cast<long long>(left_out);
    }
    if (!sheet::on_paper(layer, {paper.width, paper.height}))
      result.warnings.push_back("dimensions of the view '" + drawing.name +
                                "' extend beyond the sheet\n  hint: use a smaller scale or a larger sheet");
    add_boxes(around.boxes, layer, *lettering);
    result.layers.push_back(std::move(layer));
  }
  std::move(marks.begin(), marks.end(), std::back_inserter(result.layers));
  return result;
}

}  // namespace epura::pipeline
