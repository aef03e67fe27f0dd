// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "sheet/free_rectangles.hpp"

namespace epura::sheet {

namespace {

constexpr double table_apart = 3;                      // mm, from everything else
constexpr double origin_radius = 0.5, origin_arm = 3;  // of the height of capitals
constexpr int origin_parts = 24, origin_steps = 24;    // of the circle; by which arms may be longer, in heights

void add_table_line(Layer& layer, const Vec2& from, const Vec2& to) {
  layer.strokes.emplace_back().points = {from, to};
}

}  // namespace

std::string recesses_of(const features::HoleFeature& hole, const Notation& notation) {
  const auto length = [&](double value) { return length_text(value, notation); };
  std::string text;
  if (hole.thread && hole.thread->length) text += " ↧" + length(*hole.thread->length);
  // Of a thread that ends before its core hole does, both. ISO 6410-1.
  if (hole.depth && hole.thread && hole.thread->length) text += "/⌀" + length(hole.diameter);
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

TextTable text_table(const HoleTable& table, const std::vector<std::string>& captions) {
  TextTable texts{{}, captions, {}};
  for (const HoleRow& row : table.rows) texts.rows.push_back({row.label, row.x, row.y, row.size});
  return texts;
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
    // On the axis of a round part it is not: there the letter is beyond the lines.
    const auto letter_at = [&, along = along](int step) {
      return at + aside + (arm + (0.7 + step) * style.text) * along;
    };
    const auto is_on_lines = [&](int step) {
      return ink_in({letter_at(step), {1, 0}, Vec2(style.text / 2)}, drawing) > 0;
    };
    int step = 0;
    while (step < origin_steps && is_on_lines(step)) ++step;
    const Vec2 letter = letter_at(step % origin_steps), tip = letter - 0.7 * style.text * along;
    check(glm::distance(letter, at) > radius, "letters of an origin are beside its circle");
    add_table_line(layer, at + aside, tip);
    layer.fills.push_back(arrow_at(tip, along, style));
    layer.texts.push_back({name, letter - Vec2(0, style.text / 2), style.text, 0, Align::middle, "dimension"});
  }
}

std::optional<Vec2> free_corner(const Rectangle& room, std::span<const Rectangle> taken, const Vec2& size) {
  std::vector<Rectangle> grown;
  for (const Rectangle& one : taken) grown.push_back(one.grown(table_apart));
  std::optional<Vec2> best;
  for (const Rectangle& free : free_rectangles(room.grown(-table_apart), grown)) {
    if (free.size().x < size.x || free.size().y < size.y) continue;
    if (!best || std::tuple(free.max.y, free.max.x) > std::tuple(best->y, best->x)) best = free.max;
  }
  return best;
}

}  // namespace epura::sheet
