// SPDX-License-Identifier: Apache-2.0
#include "pipeline/construction_layers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sheet/construction_layer.hpp"
#include "sheet/free_rectangles.hpp"
#include "sheet/table_drawing.hpp"

namespace epura::pipeline {

namespace {

constexpr double legend_text = 2.5, around_legend = 4;  // mm

// Whether nothing of a figure meets other views and blocks, so that nothing of it needs to be cut off.
bool is_clear(const construction::Figure& figure, const std::vector<sheet::Rectangle>& taken) {
  if (!figure.curves.empty()) return false;
  return std::all_of(figure.lines.begin(), figure.lines.end(), [&](const construction::Line& line) {
    const sheet::TurnedBox box = sheet::line_box(line.from, line.to);
    return line.extent == construction::Extent::segment &&
           std::none_of(taken.begin(), taken.end(),
                        [&](const sheet::Rectangle& one) { return sheet::overlap(box, sheet::turned_box(one)); });
  });
}

// Where the constructions of some views may be: in the free part of the sheet that holds the views and most of what is
// constructed; of several, in the largest.
sheet::ConstructionRoom room_for_constructions(const std::vector<std::size_t>& own, const sheet::Neighbours& around,
                                               const sheet::SheetFurniture& furniture,
                                               std::span<const ViewResult> views) {
  constexpr double from_border = 5, apart = 3;  // mm
  constexpr double farthest = 2;                // sizes of the views
  sheet::ConstructionRoom room{around.paper->grown(-from_border), around.boxes};
  std::vector<sheet::Rectangle> taken;
  std::optional<sheet::Rectangle> ink;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const sheet::Rectangle box{views[i].drawing.min, views[i].drawing.max};
    if (std::find(own.begin(), own.end(), i) == own.end()) {
      taken.push_back(box.grown(apart));
    } else {
      ink = ink ? sheet::united(*ink, box) : box;
      room.views.push_back(&views[i].drawing);
    }
  }
  if (const auto blocks = sheet::block_boxes(furniture).all) taken.push_back(blocks->grown(apart));
  for (const sheet::Rectangle& one : taken) room.taken.push_back(sheet::turned_box(one));
  if (std::all_of(own.begin(), own.end(),
                  [&](std::size_t i) { return is_clear(views[i].drawing.construction, taken); })) {
    room.area = sheet::united(room.area, *ink);
    return room;
  }
  const auto size = [](const Vec2& sides) { return std::max(sides.x, 0.0) * std::max(sides.y, 0.0); };
  sheet::Rectangle wanted = *ink;
  for (const std::size_t i : own)
    wanted = sheet::box_of(views[i].drawing.construction, wanted, farthest * glm::length(ink->size()));
  const auto worth = [&](const sheet::Rectangle& free) {
    const Vec2 held = glm::min(free.max, wanted.max) - glm::max(free.min, wanted.min);
    return std::pair(std::round(size(held)), size(free.size()));
  };
  std::optional<sheet::Rectangle> best;
  for (const sheet::Rectangle& free : sheet::free_rectangles(sheet::united(room.area, *ink), taken))
    if (free.holds(*ink, 1e-6) && (!best || worth(free) > worth(*best))) best = free;
  room.area = best.value_or(ink->grown(apart));
  return room;
}

// The legend of all constructions, if it is asked for or the sheet has a frame with text.
void add_legend(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  sheet::TextTable table;
  bool wanted = input.plan.furniture.frame == FrameKind::full;
  sheet::Layer* layer = nullptr;
  sheet::ConstructionRoom room{around.paper->grown(-5), around.boxes};
  for (std::size_t i = 0; i < views.size(); ++i) {
    const construction::Figure& figure = views[i].drawing.construction;
    room.taken.push_back(sheet::turned_box({views[i].drawing.min, views[i].drawing.max}));
    if (figure.empty()) continue;
    wanted = wanted || figure.legend;
    if (layer == nullptr && !result.constructions[i].empty()) layer = &result.constructions[i].front();
    for (const construction::Term& term : figure.terms)
      if (const std::vector<std::string> row{term.symbol, term.meaning};
          std::find(table.rows.begin(), table.rows.end(), row) == table.rows.end())
        table.rows.push_back(row);
  }
  if (!wanted || layer == nullptr || table.rows.empty()) return;
  sheet::DimensionStyle small = style;
  small.text = legend_text;
  const sheet::TableDrawing drawing(std::move(table), 1, small);
  const auto corner = sheet::clear_position(room, drawing.size());
  if (!corner) {
    result.warnings.emplace_back(
        "the sheet has no room for the legend of the constructions\n  hint: use a larger sheet");
    return;
  }
  drawing.draw(*layer, *corner + drawing.size(), "construction");
  around.boxes.push_back(sheet::turned_box({*corner, *corner + drawing.size()}));
}

}  // namespace

double legend_room(const construction::Figure& figure) {
  return figure.legend ? sheet::height_of_rows(figure.terms.size(), legend_text) + around_legend : 0;
}

void add_constructions(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                       std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    const drawing::ViewDrawing& drawing = views[i].drawing;
    if (drawing.construction.empty()) continue;
    std::vector<std::size_t> own{i};
    if (input.views.epura && input.views.epura->elevation == i) own.push_back(input.views.epura->plan);
    sheet::ConstructionLayer drawn = sheet::construction_layer(
        drawing.name, drawing.construction, room_for_constructions(own, around, input.plan.furniture, views), style);
    if (drawn.without_place > 0)
      result.warnings.push_back("there is no place for a figure beside the view '" + drawing.name +
                                "'\n  hint: use a larger sheet or a smaller scale");
    result.constructions[i].push_back(std::move(drawn.layer));
  }
  for (const std::vector<sheet::Layer>& layers : result.constructions)
    for (const sheet::Layer& layer : layers) {
      const std::vector<sheet::TurnedBox> more = sheet::boxes_of(layer, style.lettering);
      around.boxes.insert(around.boxes.end(), more.begin(), more.end());
    }
  add_legend(result, around, input, views, style);
}

}  // namespace epura::pipeline
