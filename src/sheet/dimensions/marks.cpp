// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/marks.hpp"

#include <cmath>
#include <numbers>

#include "base/portable_math.hpp"

namespace epura::sheet {

namespace {

constexpr double half_tip = 10 * std::numbers::pi / 180;
constexpr double air = 0.15;  // around a text, relative to its height
constexpr double upright = 1e-6;

}  // namespace

Vec2 reading_direction(const Vec2& along) {
  const bool vertical = std::abs(along.x) <= upright;
  return (vertical ? along.y > 0 : along.x > 0) ? along : -along;
}

Fill arrow_at(const Vec2& tip, const Vec2& direction, const DimensionStyle& style) {
  const Vec2 foot = tip - style.arrow() * direction;
  const Vec2 across = style.arrow() * portable_tan(half_tip) * left_of(direction);
  return {{{tip, foot + across, foot - across}}};
}

void add_line(PlacedDimension& dimension, const Vec2& from, const Vec2& to) {
  dimension.strokes.emplace_back().points = {from, to};
}

void add_crossable_line(PlacedDimension& dimension, const Vec2& from, const Vec2& to) {
  add_line(dimension, from, to);
  dimension.lines.push_back(line_box(from, to));
}

void set_text(PlacedDimension& dimension, const std::string& text, const TextPosition& at,
              const DimensionStyle& style) {
  const double degrees = portable_atan2(at.read.y, at.read.x) * 180 / std::numbers::pi;
  dimension.text = {text, at.middle + at.rise * left_of(at.read), style.text, degrees, Align::middle, "dimension"};
  dimension.text_box = {at.middle + (at.rise + style.text / 2) * left_of(at.read),
                        at.read,
                        {style.width(text) / 2 + air * style.text, style.text / 2 + air * style.text}};
}

}  // namespace epura::sheet
