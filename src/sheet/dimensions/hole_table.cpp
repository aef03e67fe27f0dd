// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/hole_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "sheet/free_rectangles.hpp"

namespace epura::sheet {

namespace {

constexpr double row_height = 1.8, side = 0.5, base_line = 0.4;  // of the height of capitals
constexpr double between_blocks = 1;                             // likewise
constexpr double apart = 3;                                      // mm, from everything else
constexpr double origin_radius = 0.5, origin_arm = 3;            // of the height of capitals
constexpr int origin_parts = 24;

double height_of(const DimensionStyle& style) { return row_height * style.text; }

void add_line(Layer& layer, const Vec2& from, const Vec2& to) { layer.strokes.emplace_back().points = {from, to}; }

}  // namespace

std::string recesses_of(const scene::DesignHole& hole, const Notation& notation) {
  const auto length = [&](double value) { return length_text(value, notation); };
  std::string text;
  if (hole.depth) text += " ↧" + length(*hole.depth);
  if (hole.counterbore) text += " ⌴⌀" + length(hole.counterbore->diameter) + " ↧" + length(hole.counterbore->size);
  if (hole.countersink)
    text += " ⌵⌀" + length(hole.countersink->diameter) + "×" + angle_text(hole.countersink->size, notation);
  return text;
}

std::string letters_of(std::size_t group) {
  constexpr std::string_view letters = "ABCDEFGHJKLMNPRSTUVWXYZ";
  const std::string last(1, letters[group % letters.size()]);
  return group < letters.size() ? last : letters_of(group / letters.size() - 1) + last;
}

TableDrawing::TableDrawing(const HoleTable& table, const std::vector<std::string>& captions, int columns,
                           const DimensionStyle& style)
    : columns_(columns), style_(style) {
  rows_.push_back(captions);
  for (const HoleRow& row : table.rows) rows_.push_back({row.label, row.x, row.y, row.size});
  widths_.assign(captions.size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths_[i] = std::max(widths_[i], style.width(row[i]) + 2 * side * style.text);
}

Vec2 TableDrawing::size() const {
  double width = 0;
  for (const double one : widths_) width += one;
  const std::size_t count = rows_.size() - 1, blocks = static_cast<std::size_t>(columns_);
  const std::size_t longest = (count + blocks - 1) / blocks + 1;
  return {columns_ * width + (columns_ - 1) * between_blocks * style_.text,
          static_cast<double>(longest) * height_of(style_)};
}

void TableDrawing::draw(Layer& layer, const Vec2& corner) const {
  const double height = height_of(style_);
  const std::size_t count = rows_.size() - 1, blocks = static_cast<std::size_t>(columns_);
  const std::size_t in_block = (count + blocks - 1) / blocks;
  double left = corner.x - size().x;
  for (std::size_t begin = 0; begin < count; begin += in_block) {
    const std::size_t rows = std::min(in_block, count - begin);
    const double bottom = corner.y - static_cast<double>(rows + 1) * height;
    std::vector<double> edges{left};
    for (const double width : widths_) edges.push_back(edges.back() + width);
    for (const double x : edges) add_line(layer, {x, bottom}, {x, corner.y});
    // Texts in reading order, for programs that extract them.
    for (std::size_t i = 0; i <= rows; ++i) {
      const double top = corner.y - static_cast<double>(i) * height;
      add_line(layer, {left, top}, {edges.back(), top});
      const std::vector<std::string>& words = rows_[i == 0 ? 0 : begin + i];
      for (std::size_t column = 0; column < words.size(); ++column) {
        const Vec2 at(edges[column] + side * style_.text, top - height + base_line * style_.text);
        layer.texts.push_back({words[column], at, style_.text, 0, Align::left, "dimension"});
      }
    }
    add_line(layer, {left, bottom}, {edges.back(), bottom});
    left = edges.back() + between_blocks * style_.text;
  }
}

void draw_origin(Layer& layer, const HoleTable& table, const drawing::ViewDrawing& drawing,
                 const DimensionStyle& style) {
  const Vec2 at(drawing.world_to_page * Vec4(table.origin, 1));
  const double radius = origin_radius * style.text, arm = origin_arm * style.text;
  layer.strokes.push_back(circle_at(at, radius, origin_parts));
  const std::array<std::pair<Vec2, const char*>, 2> axes{{{{1, 0}, "X"}, {{0, 1}, "Y"}}};
  for (const auto& [along, name] : axes) {
    // Beside the outline, outside the view.
    const Vec2 aside = -1.0 * Vec2(along.y, along.x) * (radius + 0.5 * style.text);
    const Vec2 tip = at + aside + arm * along;
    add_line(layer, at + aside, tip);
    layer.fills.push_back(arrow_at(tip, along, style));
    const Vec2 beyond = tip + 0.7 * style.text * along - Vec2(0, style.text / 2);
    layer.texts.push_back({name, beyond, style.text, 0, Align::middle, "dimension"});
  }
}

std::optional<Vec2> free_corner(const Rectangle& room, std::span<const Rectangle> taken, const Vec2& size) {
  std::vector<Rectangle> grown;
  for (const Rectangle& one : taken) grown.push_back(one.grown(apart));
  std::optional<Vec2> best;
  for (const Rectangle& free : free_rectangles(room.grown(-apart), grown)) {
    if (free.size().x < size.x || free.size().y < size.y) continue;
    if (!best || std::tuple(free.max.y, free.max.x) > std::tuple(best->y, best->x)) best = free.max;
  }
  return best;
}

}  // namespace epura::sheet
