// SPDX-License-Identifier: Apache-2.0
#include "pipeline/annotation_layers.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "pipeline/details.hpp"
#include "sheet/cutting_plane_line.hpp"
#include "sheet/detail_marks.hpp"
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
    for (const scene::CuttingSurface& section : annotations[i].planes)
      if (auto mark = sheet::cutting_plane_line(views[i].drawing, section, widths))
        by_name.emplace(section.plane.name, std::move(*mark));
  std::vector<sheet::Layer> marks;
  for (auto& [name, mark] : by_name) marks.push_back(std::move(mark));
  return marks;
}

void add_boxes(std::vector<sheet::TurnedBox>& boxes, const sheet::Layer& layer, const sheet::Lettering& lettering) {
  const std::vector<sheet::TurnedBox> more = sheet::boxes_of(layer, lettering);
  boxes.insert(boxes.end(), more.begin(), more.end());
}

// The lines around details in the views that they enlarge.
sheet::Layer boundaries_of(std::span<const Annotations> annotations, std::span<const ViewResult> views) {
  sheet::Layer layer;
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const scene::DetailDescription& detail : annotations[i].details)
      layer.strokes.push_back(sheet::boundary_line(boundary_on_page(detail, views[i].drawing)));
  return layer;
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

// Where centre lines of features will be, so that no text is on them.
void add_centre_lines(std::vector<sheet::TurnedBox>& boxes, const ViewResult& view) {
  constexpr double past = 3;  // mm
  const drawing::ViewDrawing& drawing = view.drawing;
  const auto page = [&drawing](const Vec3& p) { return drawing::position_on_page(drawing, p); };
  const auto add = [&](const scene::RoundFeature& round) {
    const Vec2 from = page(round.rings.front().centre), to = page(round.rings.back().centre);
    double radius = 0;
    for (const scene::Ring& ring : round.rings) radius = std::max(radius, ring.radius);
    const double reach = radius * drawing.scale + past, length = glm::length(to - from);
    if (length > past) {
      const Vec2 along = (to - from) / length;
      boxes.push_back(sheet::line_box(from - past * along, to + past * along));
    } else {
      boxes.push_back(sheet::line_box(from - Vec2(reach, 0), from + Vec2(reach, 0)));
      boxes.push_back(sheet::line_box(from - Vec2(0, reach), from + Vec2(0, reach)));
    }
  };
  for (const scene::RoundFeature& round : view.features.round) add(round);
  for (const scene::SlotFeature& slot : view.features.slots)
    for (const scene::RoundFeature& end : slot.ends) add(end);
}

// Faults of the dimensions of one view on paper. ISO 3098-1: lettering is at least 2.5 mm high.
void note_faults(std::vector<report::Finding>& findings, const std::string& view, const sheet::PlacedLayer& placed,
                 const sheet::Paper& paper) {
  constexpr double least_height = 2.5;
  for (const std::string& crossing : placed.crossings)
    findings.push_back({report::FindingKind::crossing, view, crossing});
  for (const sheet::Text& text : placed.layer.texts)
    if (text.height < least_height) findings.push_back({report::FindingKind::small_text, view, "'" + text.text + "'"});
  if (!sheet::on_paper(placed.layer, {paper.width, paper.height}))
    findings.push_back({report::FindingKind::off_sheet, view, "dimensions extend beyond the sheet"});
}

}  // namespace

AnnotationLayers annotation_layers(const SheetInput& input, std::span<const ViewResult> views,
                                   const std::vector<sheet::Text>& labels, const Budget& budget) {
  const sheet::SheetFurniture& furniture = input.plan.furniture;
  const sheet::Paper& paper = furniture.paper;
  const sheet::LineWidths widths = sheet::line_widths(paper);
  const sheet::Notation notation =
      notation_of(input.world, input.scene.sheets[static_cast<std::size_t>(input.views.sheet)]);
  AnnotationLayers result;
  std::vector<sheet::Layer> marks = marks_of(input.annotations, views, widths);
  std::optional<sheet::Lettering> lettering;
  sheet::Neighbours around;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::vector<scene::DimensionDescription> dimensions = dimensions_of(input.annotations[i], views[i]);
    if (dimensions.empty()) continue;
    if (!lettering) {
      around = neighbours_of(furniture, labels, marks, lettering.emplace(furniture.font));
      add_boxes(around.boxes, boundaries_of(input.annotations, views), *lettering);
    }
    const sheet::DimensionStyle style{*lettering, widths.narrow, dimension_text_height(paper, views.size()), notation};
    const drawing::ViewDrawing& drawing = views[i].drawing;
    sheet::Neighbours neighbours = with_other_views(around, views, i);
    if (dimensions_features(input.scene)) add_centre_lines(neighbours.boxes, views[i]);
    sheet::PlacedLayer placed = sheet::place_dimensions({input.world, drawing, dimensions}, style, neighbours,
                                                        budget.run.with_part_of_the_time(0.5));
    sheet::Layer& layer = placed.layer;
    note_faults(result.findings, drawing.name, placed, paper);
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
