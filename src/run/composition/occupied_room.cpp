// SPDX-License-Identifier: Apache-2.0
#include "composition/occupied_room.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "composition/centre_layers.hpp"
#include "drawing/drawing.hpp"
#include "sheet/boxes.hpp"
#include "sheet/frame.hpp"

namespace epura::pipeline {

namespace {

// The centring marks inside the frame. ISO 5457
std::vector<sheet::Rectangle> centring_marks(const sheet::SheetFurniture& furniture) {
  constexpr double inside = 10;  // mm
  if (furniture.frame != FrameKind::full) return {};
  const sheet::Rectangle area = sheet::drawing_area(furniture.paper);
  const Vec2 middle = Vec2(furniture.paper.width, furniture.paper.height) / 2.0;
  std::vector<sheet::Rectangle> marks;
  for (const double x : {area.min.x, area.max.x - inside}) marks.push_back({{x, middle.y}, {x + inside, middle.y}});
  for (const double y : {area.min.y, area.max.y - inside}) marks.push_back({{middle.x, y}, {middle.x, y + inside}});
  return marks;
}

/// Square cells of a sheet that boxes occupy.
class Cells {
 public:
  explicit Cells(const sheet::Rectangle& room)
      : room_(room),
        side_(std::max(room.size().x, room.size().y) / max_along),
        columns_(count(room.size().x)),
        occupied_(columns_ * count(room.size().y), false) {}

  void add(const sheet::Rectangle& box) {
    const auto first = [&](double at) { return std::size_t(std::clamp(std::floor(at / side_), 0.0, max_along - 1)); };
    const Vec2 min = box.min - room_.min, max = box.max - room_.min;
    if (max.x < 0 || max.y < 0 || min.x > room_.size().x || min.y > room_.size().y) return;
    const std::size_t rows = occupied_.size() / columns_;
    for (std::size_t row = first(min.y); row <= std::min(first(max.y), rows - 1); ++row)
      for (std::size_t column = first(min.x); column <= std::min(first(max.x), columns_ - 1); ++column)
        occupied_[row * columns_ + column] = true;
  }

  // Neighbours in a row are one rectangle.
  void list(std::vector<sheet::Rectangle>& taken) const {
    for (std::size_t cell = 0; cell < occupied_.size(); ++cell) {
      if (!occupied_[cell]) continue;
      const Vec2 low = room_.min + side_ * Vec2(double(cell % columns_), double(cell / columns_));
      if (cell % columns_ > 0 && occupied_[cell - 1])
        taken.back().max = low + side_;
      else
        taken.push_back({low, low + side_});
    }
  }

 private:
  static constexpr double max_along = 64;

  [[nodiscard]] std::size_t count(double length) const {
    return std::size_t(std::clamp(std::ceil(length / side_), 1.0, max_along));
  }

  sheet::Rectangle room_;
  double side_;
  std::size_t columns_;
  std::vector<bool> occupied_;
};

}  // namespace

void add_boxes(std::vector<sheet::TurnedBox>& boxes, const sheet::Layer& layer, const sheet::Lettering& lettering) {
  const std::vector<sheet::TurnedBox> more = sheet::boxes_of(layer, lettering);
  boxes.insert(boxes.end(), more.begin(), more.end());
}

void add_outlines(std::vector<sheet::TurnedBox>& boxes, const sheet::Layer& symbols) {
  for (const sheet::Stroke& stroke : symbols.strokes) {
    sheet::Rectangle box{stroke.points.front(), stroke.points.front()};
    for (const Vec2& p : stroke.points) box = sheet::united(box, {p, p});
    boxes.push_back(sheet::turned_box(box));
  }
}

sheet::Neighbours neighbours_of(const sheet::SheetFurniture& furniture, const std::vector<sheet::Text>& labels,
                                const std::vector<sheet::Layer>& marks, const sheet::Lettering& lettering) {
  const sheet::Paper& paper = furniture.paper;
  sheet::Neighbours neighbours;
  neighbours.paper = furniture.frame == FrameKind::none ? sheet::Rectangle{{0, 0}, {paper.width, paper.height}}
                                                        : sheet::drawing_area(paper);
  const sheet::BlockBoxes blocks = sheet::block_boxes(furniture);
  for (const auto& box : {blocks.title_block, blocks.parts_list, blocks.revisions})
    if (box) {
      neighbours.boxes.push_back(sheet::turned_box(*box));
      neighbours.views.push_back(neighbours.boxes.back());
    }
  for (const sheet::Rectangle& mark : centring_marks(furniture)) neighbours.boxes.push_back(sheet::turned_box(mark));
  for (const sheet::Text& label : labels) neighbours.texts.push_back(sheet::box_of(label, lettering));
  neighbours.boxes.insert(neighbours.boxes.end(), neighbours.texts.begin(), neighbours.texts.end());
  for (const sheet::Layer& mark : marks) {
    add_boxes(neighbours.boxes, mark, lettering);
    for (const sheet::Text& letter : mark.texts) neighbours.letters.push_back(sheet::box_of(letter, lettering));
  }
  return neighbours;
}

sheet::Neighbours with_other_views(sheet::Neighbours neighbours, std::span<const ViewResult> views, std::size_t view) {
  constexpr double along_outline = 1;  // mm, in which a line would be taken for one of that view
  for (std::size_t i = 0; i < views.size(); ++i) {
    const sheet::Rectangle box{views[i].drawing.box.min, views[i].drawing.box.max};
    if (i == view) continue;
    neighbours.boxes.push_back(sheet::turned_box(box));
    neighbours.views.push_back(sheet::turned_box(box.grown(along_outline)));
  }
  return neighbours;
}

void add_centre_lines(std::vector<sheet::TurnedBox>& boxes, const SheetInput& input, std::span<const ViewResult> views,
                      const sheet::Lettering& lettering) {
  const sheet::LineWidths widths = sheet::line_widths(input.plan.furniture.paper, input.plan.furniture.styles);
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const sheet::Layer& layer : centre_layers(views[i], input.views.plans[i].options, widths, {}))
      add_boxes(boxes, layer, lettering);
}

std::vector<sheet::Rectangle> taken_by(const sheet::Neighbours& around, std::span<const ViewResult> views) {
  constexpr std::size_t most = 200;
  std::vector<sheet::Rectangle> taken;
  for (const ViewResult& view : views) taken.push_back({view.drawing.box.min, view.drawing.box.max});
  if (taken.size() + around.boxes.size() <= most || !around.paper) {
    for (const sheet::TurnedBox& box : around.boxes) taken.push_back(sheet::around(box));
    return taken;
  }
  Cells cells(*around.paper);
  for (const sheet::TurnedBox& box : around.boxes) cells.add(sheet::around(box));
  cells.list(taken);
  return taken;
}

}  // namespace epura::pipeline
