// SPDX-License-Identifier: Apache-2.0
#include "annotations/view_labels.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/place_items.hpp"
#include "scene/line_roles.hpp"
#include "sheet/boxes.hpp"
#include "sheet/label_positions.hpp"

namespace epura::sheet {

namespace {

constexpr double label_clearance = 1;    // mm, around a label
constexpr double below_brackets = 0.25;  // of brackets, in text heights
constexpr double up_step = 1, farthest_up = 30;
constexpr std::array<double, 11> aside{0, -5, 5, -10, 10, -20, 20, -30, 30, -40, 40};

Rectangle box_of_label(const Text& text, const Lettering& lettering) {
  Rectangle box = around(box_of(text, lettering));
  box.min.y -= below_brackets * text.height;
  return box.grown(label_clearance);
}

// Lines of the dimensions of the view above which the label stands.
std::vector<Rectangle> dimensions_of_its_view(const Text& label, const Sheet& sheet) {
  constexpr double same = 1e-6;  // mm
  const auto view = std::ranges::find_if(sheet.views, [&](const ViewFrame& one) {
    return glm::distance(label_above({}, {one.min, one.max}).at, label.at) < same;
  });
  std::vector<Rectangle> lines;
  if (view == sheet.views.end()) return lines;
  const std::string name = view->name + "/" + scene::row_of(scene::SheetLine::dimension).layer;
  for (const Layer& layer : sheet.layers)
    for (const Stroke& stroke : layer.strokes)
      for (std::size_t i = 1; i < stroke.points.size() && layer.name == name; ++i)
        lines.push_back(around(line_box(stroke.points[i - 1], stroke.points[i])));
  return lines;
}

// Where it is, then upwards, then to either side.
std::vector<ItemPlacement> placements_of(const Rectangle& box, const std::vector<Rectangle>& dimensions) {
  constexpr double for_side = 4;
  const auto is_below_dimension = [&](const Rectangle& moved) {
    return std::ranges::any_of(dimensions, [&](const Rectangle& line) {
      return line.min.y >= moved.max.y - label_clearance && line.min.x < moved.centre().x &&
             line.max.x > moved.centre().x;
    });
  };
  std::vector<ItemPlacement> placements;
  for (std::size_t i = 0; i < aside.size(); ++i)
    for (double y = 0; y <= farthest_up; y += up_step) {
      const Vec2 move(aside[i], y);
      const Rectangle moved{box.min + move, box.max + move};
      PlacedDimension label;
      label.zones = {turned_box(moved)};
      label.text_boxes = label.zones;
      placements.push_back({std::move(label), for_side * static_cast<double>(i) + cost_of_farther * y +
                                                  (is_below_dimension(moved) ? cost_of_letter : 0)});
    }
  check(!placements.empty(), "a label may stay");
  return placements;
}

// What is not a label, near some.
Neighbours around_labels(const Sheet& sheet, const Rectangle& area, const std::vector<Rectangle>& labels,
                         const Lettering& lettering) {
  const Vec2 reach(*std::max_element(aside.begin(), aside.end()), farthest_up);
  Neighbours around_them;
  around_them.paper = area;
  for (Layer layer : sheet.layers) {
    if (layer.name == "sheet/text") std::erase_if(layer.texts, [](const Text& one) { return one.role == "label"; });
    for (const TurnedBox& box : boxes_of(layer, lettering))
      if (std::ranges::any_of(labels, [&](const Rectangle& label) {
            return Rectangle{label.min - reach, label.max + reach}.overlaps(around(box).grown(label_clearance));
          }))
        around_them.boxes.push_back(box);
  }
  return around_them;
}

}  // namespace

void clear_labels(Sheet& sheet, const Rectangle& area, const Lettering& lettering) {
  std::vector<Text*> labels;
  for (Layer& layer : sheet.layers)
    for (Text& text : layer.texts)
      if (layer.name == "sheet/text" && text.role == "label") labels.push_back(&text);
  std::vector<Rectangle> boxes;
  std::vector<PlacementItem> items(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Rectangle& box = boxes.emplace_back(box_of_label(*labels[i], lettering));
    items[i].usual = [box, lines = dimensions_of_its_view(*labels[i], sheet)](const PlacedDimension*) {
      return placements_of(box, lines);
    };
  }
  const PlacedDimensions placed =
      place_items(items, {drawing::ViewDrawing(), around_labels(sheet, area, boxes, lettering)});
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i]->at += placed[i]->zones.front().centre - turned_box(boxes[i]).centre;
  check(boxes.size() == labels.size(), "every label has a place");
}

}  // namespace epura::sheet
