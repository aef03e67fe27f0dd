// SPDX-License-Identifier: Apache-2.0
#include "sheet/label_positions.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/line_roles.hpp"
#include "sheet/boxes.hpp"
#include "sheet/standard_scale.hpp"

namespace epura::sheet {

namespace {

constexpr double label_clearance = 1;    // mm, between a label and lines
constexpr double below_brackets = 0.25;  // of brackets, in text heights
constexpr double up_step = 1, farthest_up = 30;
constexpr std::array<double, 11> aside{0, -5, 5, -10, 10, -20, 20, -30, 30, -40, 40};

Rectangle box_on_paper(const Text& text, const Lettering& lettering) { return around(box_of(text, lettering)); }

struct Obstacles {
  std::vector<TurnedBox> boxes;
  std::vector<Rectangle> dimensions;  // lines of the dimensions of the view
};

void add_stroke(Obstacles& obstacles, const Stroke& stroke, const Rectangle& region, bool is_dimension) {
  const std::size_t count = stroke.points.size();
  for (std::size_t i = 0; i + 1 < count + (stroke.closed ? 1 : 0); ++i) {
    const Vec2 &a = stroke.points[i], &b = stroke.points[(i + 1) % count];
    const Rectangle box{glm::min(a, b), glm::max(a, b)};
    if (!region.overlaps(box.grown(label_clearance))) continue;
    obstacles.boxes.push_back(line_box(a, b));
    if (is_dimension) obstacles.dimensions.push_back(box);
  }
}

Rectangle box_of_ring(const std::vector<Vec2>& ring) {
  Rectangle box{ring.front(), ring.front()};
  for (const Vec2& p : ring) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

// Name of the layer with the dimensions of the view above which the label stands.
std::string dimensions_of_its_view(const Text& label, const Sheet& sheet) {
  constexpr double same = 1e-6;  // mm
  for (const ViewFrame& view : sheet.views) {
    const Vec2 at = label_above({}, {view.min, view.max}).at;
    if (glm::distance(at, label.at) < same) return view.name + "/" + scene::row_of(scene::SheetLine::dimension).layer;
  }
  return {};
}

Obstacles obstacles_in(const Sheet& sheet, const Rectangle& region, const Text& label, const Lettering& lettering) {
  Obstacles obstacles;
  const std::string dimensions = dimensions_of_its_view(label, sheet);
  for (const Layer& layer : sheet.layers) {
    const bool is_dimension = layer.name == dimensions;
    for (const Stroke& stroke : layer.strokes) add_stroke(obstacles, stroke, region, is_dimension);
    for (const Fill& fill : layer.fills)
      for (const std::vector<Vec2>& ring : fill.rings)
        if (!ring.empty() && region.overlaps(box_of_ring(ring)))
          obstacles.boxes.push_back(turned_box(box_of_ring(ring)));
    for (const Text& text : layer.texts)
      if (&text != &label && region.overlaps(box_on_paper(text, lettering)))
        obstacles.boxes.push_back(box_of(text, lettering));
  }
  return obstacles;
}

bool is_free(const Rectangle& box, const Obstacles& obstacles) {
  const TurnedBox turned = turned_box(box.grown(label_clearance));
  return std::none_of(obstacles.boxes.begin(), obstacles.boxes.end(),
                      [&](const TurnedBox& obstacle) { return overlap(turned, obstacle); });
}

// Whether a dimension line runs above the box.
bool is_below_dimension(const Rectangle& box, const Obstacles& obstacles) {
  return std::any_of(obstacles.dimensions.begin(), obstacles.dimensions.end(), [&](const Rectangle& line) {
    return line.min.y >= box.max.y && line.min.x < box.centre().x && line.max.x > box.centre().x;
  });
}

// How far to move the label.
std::optional<Vec2> free_move(const Rectangle& box, const Obstacles& obstacles, const Rectangle& area,
                              bool above_dimensions) {
  for (const double x : aside)
    for (double y = 0; y <= farthest_up; y += up_step) {
      const Rectangle moved{box.min + Vec2(x, y), box.max + Vec2(x, y)};
      if (!area.holds(moved.grown(label_clearance))) break;
      if (is_free(moved, obstacles) && !(above_dimensions && is_below_dimension(moved, obstacles))) return Vec2(x, y);
    }
  return std::nullopt;
}

Vec2 move_of(const Text& label, const Sheet& sheet, const Rectangle& area, const Lettering& lettering) {
  Rectangle box = box_on_paper(label, lettering);
  box.min.y -= below_brackets * label.height;
  const Vec2 reach(*std::max_element(aside.begin(), aside.end()), farthest_up);
  const Obstacles obstacles = obstacles_in(sheet, Rectangle{box.min - reach, box.max + reach}, label, lettering);
  auto move = free_move(box, obstacles, area, true);
  if (!move) move = free_move(box, obstacles, area, false);
  check(!move || move->y >= 0, "a label goes up");
  return move.value_or(Vec2(0, 0));
}

}  // namespace

void clear_labels(Sheet& sheet, const Rectangle& area, const Lettering& lettering) {
  for (Layer& layer : sheet.layers) {
    if (layer.name != "sheet/text") continue;
    for (Text& text : layer.texts)
      if (text.role == "label") text.at += move_of(text, sheet, area, lettering);
  }
}

namespace {

constexpr double height = 5;
constexpr double above_ink = 3;  // together with the height less than label_room

}  // namespace

std::string view_label(const std::string& label, std::optional<double> scale, double main_scale, DecimalSign sign) {
  const std::string ratio = scale && *scale != main_scale ? with_decimal_sign(ratio_text(*scale), sign) : "";
  if (ratio.empty()) return label;
  return (label.empty() ? "" : label + " ") + "(" + ratio + ")";
}

Text label_above(const std::string& label, const Rectangle& ink) {
  return {label, {ink.centre().x, ink.max.y + above_ink}, height, 0, Align::middle, "label"};
}

}  // namespace epura::sheet
