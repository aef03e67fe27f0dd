// SPDX-License-Identifier: Apache-2.0
#include "composition/construction_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "annotations/construction_layer.hpp"
#include "construction/figure.hpp"
#include "drawing/drawing.hpp"
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

// Where the constructions of some views may be: in the free part of the sheet, clear of other views and blocks, that
// holds the views and most of what is constructed; of several, in the largest.
sheet::ConstructionRoom room_for_constructions(const std::vector<std::size_t>& own, const sheet::Neighbours& around,
                                               const sheet::SheetFurniture& furniture,
                                               std::span<const ViewResult> views,
                                               std::span<const sheet::Rectangle> blocks) {
  constexpr double from_border = 5, apart = 3;  // mm
  constexpr double farthest = 2;                // sizes of the views
  sheet::ConstructionRoom room{around.paper->grown(-from_border), around.boxes};
  room.labels = room.area;
  std::vector<sheet::Rectangle> taken;
  std::optional<sheet::Rectangle> ink;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const sheet::Rectangle box{views[i].drawing.box.min, views[i].drawing.box.max};
    if (std::find(own.begin(), own.end(), i) == own.end()) {
      taken.push_back(box.grown(apart));
    } else {
      ink = ink ? sheet::united(*ink, box) : box;
      room.views.push_back(&views[i].drawing);
    }
  }
  if (const auto block = sheet::block_boxes(furniture).all) taken.push_back(block->grown(apart));
  for (const sheet::Rectangle& block : blocks) taken.push_back(block.grown(apart));
  for (const sheet::Rectangle& one : taken) room.taken.push_back(sheet::turned_box(one));
  if (std::all_of(own.begin(), own.end(), [&](std::size_t i) {
        const auto& figure = views[i].drawing.aids.construction;
        return !figure || is_clear(*figure, taken);
      })) {
    room.area = sheet::united(room.area, *ink);
    return room;
  }
  const auto size = [](const Vec2& sides) { return std::max(sides.x, 0.0) * std::max(sides.y, 0.0); };
  sheet::Rectangle wanted = *ink;
  for (const std::size_t i : own)
    if (views[i].drawing.aids.construction)
      wanted = sheet::box_of(*views[i].drawing.aids.construction, wanted, farthest * glm::length(ink->size()));
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

/// The legend of all constructions.
struct Legend {
  sheet::TextTable table{};
  bool is_asked_for = false;
};

Legend legend_of(std::span<const ViewResult> views) {
  Legend legend;
  std::vector<std::vector<std::string>>& rows = legend.table.rows;
  for (const ViewResult& view : views) {
    if (!view.drawing.aids.construction) continue;
    const construction::Figure& figure = *view.drawing.aids.construction;
    legend.is_asked_for = legend.is_asked_for || figure.legend;
    for (const construction::Term& term : figure.terms)
      if (const std::vector<std::string> row{term.symbol, term.meaning};
          std::find(rows.begin(), rows.end(), row) == rows.end())
        rows.push_back(row);
  }
  return legend;
}

// As far below and to the left as it touches neither views nor what is around them.
std::optional<sheet::Rectangle> place_of_legend(const Vec2& size, const sheet::Neighbours& around,
                                                std::span<const ViewResult> views) {
  std::vector<sheet::Rectangle> taken;
  for (const sheet::TurnedBox& box : around.boxes) taken.push_back(sheet::around(box));
  for (const ViewResult& view : views) taken.push_back({view.drawing.box.min, view.drawing.box.max});
  const sheet::Rectangle room = around.paper->grown(-2);  // mm
  const auto corner = sheet::nearest_free_position(room, taken, size, room.min);
  return corner ? std::optional(sheet::Rectangle{*corner, *corner + size}) : std::nullopt;
}

/// The constructions of some views, by their numbers, and what is around with them.
struct DrawnConstructions {
  std::vector<std::pair<std::size_t, sheet::ConstructionLayer>> layers{};
  sheet::Neighbours around{};
};

// First those with figures beside them, at which the lines of the others end.
DrawnConstructions draw_constructions(const SheetInput& input, std::span<const ViewResult> views,
                                      const sheet::DimensionStyle& style, sheet::Neighbours around,
                                      std::vector<sheet::Rectangle> blocks) {
  std::vector<std::size_t> order(views.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
    const auto& figure = views[i].drawing.aids.construction;
    return figure && !figure->keys.empty();
  });
  DrawnConstructions drawn;
  for (const std::size_t i : order) {
    const drawing::ViewDrawing& drawing = views[i].drawing;
    if (!drawing.aids.construction) continue;
    std::vector<std::size_t> own{i};
    if (input.views.epura && input.views.epura->elevation == i) own.push_back(input.views.epura->plan);
    const sheet::ConstructionRoom room = room_for_constructions(own, around, input.plan.furniture, views, blocks);
    sheet::ConstructionLayer layer = sheet::construction_layer(drawing.name, *drawing.aids.construction, room, style);
    const std::vector<sheet::TurnedBox> more = sheet::boxes_of(layer.layer, style.lettering);
    around.boxes.insert(around.boxes.end(), more.begin(), more.end());
    blocks.insert(blocks.end(), layer.keys.begin(), layer.keys.end());
    drawn.layers.emplace_back(i, std::move(layer));
  }
  drawn.around = std::move(around);
  return drawn;
}

}  // namespace

double legend_room(const construction::Figure& figure) {
  return figure.legend ? sheet::height_of_rows(figure.terms.size(), legend_text) + around_legend : 0;
}

// The legend has its place among what is constructed. If there is none, the constructions end at it.
void add_constructions(AnnotationLayers& result, sheet::Neighbours& around, const SheetInput& input,
                       std::span<const ViewResult> views, const sheet::DimensionStyle& style) {
  Legend legend = legend_of(views);
  sheet::DimensionStyle small = style;
  small.text = legend_text;
  const bool has_legend =
      !legend.table.rows.empty() && (legend.is_asked_for || input.plan.furniture.frame == FrameKind::full);
  DrawnConstructions drawn = draw_constructions(input, views, style, around, {});
  if (has_legend && !drawn.layers.empty()) {
    const sheet::TableDrawing table(std::move(legend.table), 1, small);
    auto place = place_of_legend(table.size(), drawn.around, views);
    if (!place && legend.is_asked_for) {
      place = place_of_legend(table.size(), around, views);
      if (place) drawn = draw_constructions(input, views, style, around, {*place});
    }
    if (place) {
      table.draw(drawn.layers.front().second.layer, {place->min.x + table.size().x, place->max.y}, "construction");
      drawn.around.boxes.push_back(sheet::turned_box(*place));
    } else {
      result.warnings.emplace_back(
          "the sheet has no room for the legend of the constructions\n  hint: use a larger sheet");
    }
  }
  around = std::move(drawn.around);
  for (auto& [view, layer] : drawn.layers) {
    const std::string& name = views[view].drawing.name;
    if (layer.without_place > 0)
      result.warnings.push_back("there is no place for a figure beside the view '" + name +
                                "'\n  hint: use a larger sheet or a smaller scale");
    for (const std::string& symbol : layer.unnamed)
      result.warnings.push_back("there is no place for the label '" + symbol + "' of the view '" + name +
                                "'\n  hint: use a larger sheet or a smaller scale");
    result.constructions[view].push_back(std::move(layer.layer));
  }
}

}  // namespace epura::pipeline
