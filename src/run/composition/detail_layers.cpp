// SPDX-License-Identifier: Apache-2.0
#include "composition/detail_layers.hpp"

#include <iterator>
#include <utility>

#include "annotations/detail_marks.hpp"
#include "drawing/drawing.hpp"
#include "sheet/frame.hpp"
#include "sheet/standard_scale.hpp"
#include "views/details.hpp"

namespace epura::pipeline {

namespace {

std::vector<sheet::DetailMark> marks_in(const Annotations& annotations, const drawing::ViewDrawing& drawing) {
  std::vector<sheet::DetailMark> marks;
  if (drawing.projection.central) return marks;
  for (const scene::DetailDescription& detail : annotations.details)
    marks.push_back({*detail.name, boundary_on_page(detail, drawing)});
  return marks;
}

sheet::LetterRoom letter_room(const std::vector<sheet::Layer>& layers, const sheet::SheetFurniture& furniture) {
  const sheet::Paper& paper = furniture.paper;
  sheet::LetterRoom room{{{0, 0}, {paper.width, paper.height}}, layers};
  if (furniture.frame != FrameKind::none) room.area = sheet::drawing_area(paper);
  if (furniture.title_block)
    if (const auto box = sheet::title_block_box(*furniture.title_block, paper))
      room.reserved.push_back(sheet::turned_box(*box));
  return room;
}

}  // namespace

void warn_about_details(const Messages& messages, const SheetOfViews& views, const SheetPlan& plan) {
  for (std::size_t i = 0; i < views.plans.size(); ++i) {
    const auto& detail = views.plans[i].options.detail;
    if (!detail) continue;
    for (std::size_t j = 0; j < views.plans.size(); ++j)
      if (views.plans[j].options.name == *detail->view && plan.places[i].scale <= plan.places[j].scale)
        messages.warn("detail '" + *detail->name + "' at " + sheet::ratio_text(plan.places[i].scale) +
                      " is not larger than in view '" + *detail->view + "' at " +
                      sheet::ratio_text(plan.places[j].scale) + "\n  hint: give its view a larger scale");
  }
}

void add_details(std::vector<sheet::Layer>& layers, const SheetInput& input,
                 std::span<const drawing::ViewDrawing> drawings) {
  const sheet::LineWidths widths = sheet::line_widths(input.plan.furniture.paper, input.plan.furniture.styles);
  std::vector<sheet::Layer> details;
  for (const drawing::ViewDrawing& drawing : drawings) {
    if (!drawing.shown.detail) continue;
    details.push_back(sheet::empty_layer(drawing.name, scene::SheetLine::detail, widths));
    details.back().strokes.push_back(sheet::boundary_line(drawing.shown.detail->boundary));
  }
  std::move(details.begin(), details.end(), std::back_inserter(layers));
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const std::vector<sheet::DetailMark> marks = marks_in(input.annotations[i], drawings[i]);
    if (marks.empty()) continue;
    sheet::Layer layer = sheet::detail_marks(drawings[i].name, marks, letter_room(layers, input.plan.furniture),
                                             sheet::Lettering(input.plan.furniture.font), widths);
    layers.push_back(std::move(layer));
  }
}

}  // namespace epura::pipeline
