// SPDX-License-Identifier: Apache-2.0
#include "sheet/marks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"

namespace epura::sheet {

namespace {

constexpr double half_tip = 10 * std::numbers::pi / 180;
constexpr double air = 0.15;  // around a text, relative to its height
constexpr double upright = 1e-6;
constexpr double min_letters = 2.5;      // mm, ISO 3098-1
constexpr double between_stacked = 0.4;  // of the height of stacked numbers

// Numbers above each other are one size of ISO 3098 smaller, if that is still legible. ISO 406.
double stacked_height(const DimensionStyle& style) {
  return std::max(std::min(style.text, min_letters), style.text / std::numbers::sqrt2);
}

// All around, the first one again at the end.
std::vector<Vec2> directions(int count) {
  std::vector<Vec2> all;
  for (int i = 0; i <= count; ++i) all.push_back(turned_to(2 * std::numbers::pi * i / count));
  return all;
}

/// Widths of a number above another one, mm: up to their decimal signs or units, and of both together. Otherwise the
/// width of the piece.
struct PieceWidth {
  double upper = 0, lower = 0, all = 0;

  [[nodiscard]] double whole() const { return std::max(upper, lower); }
};

PieceWidth width_of(const TextPiece& piece, const DimensionStyle& style) {
  if (!piece.is_stack()) return {0, 0, style.lettering.width(piece.upper, style.text)};
  const double small = stacked_height(style);
  const auto width_before_sign = [&](const std::string& number) {
    return style.lettering.width(number.substr(0, number.find_first_of(".,\xC2")), small);
  };
  PieceWidth width{width_before_sign(piece.upper), width_before_sign(piece.lower)};
  const double rest = std::max(style.lettering.width(piece.upper, small) - width.upper,
                               style.lettering.width(piece.lower, small) - width.lower);
  width.all = width.whole() + std::max(0.0, rest);
  return width;
}

}  // namespace

double DimensionStyle::width(const DimensionText& written) const {
  double width = 0;
  for (const TextPiece& piece : written.pieces) width += width_of(piece, *this).all;
  return width;
}

double DimensionStyle::height(const DimensionText& written) const {
  return written.has_stack() ? (2 + between_stacked) * stacked_height(*this) : text;
}

Vec2 reading_direction(const Vec2& along) {
  const bool vertical = std::abs(along.x) <= upright;
  return (vertical ? along.y > 0 : along.x > 0) ? along : -along;
}

Fill arrow_at(const Vec2& tip, const Vec2& direction, const DimensionStyle& style) {
  const Vec2 foot = tip - style.arrow() * direction;
  static const double slope = portable_tan(half_tip);
  const Vec2 across = style.arrow() * slope * left_of(direction);
  return {{{tip, foot + across, foot - across}}};
}

Stroke circle_at(const Vec2& centre, double radius, int parts) {
  Stroke stroke;
  for (const Vec2& direction : directions(parts)) stroke.points.push_back(centre + radius * direction);
  stroke.curves = {{0, parts, centre, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi}};
  return stroke;
}

Stroke arc_at(const Vec2& centre, double radius, double from, double to) {
  constexpr double step = std::numbers::pi / 90;
  const int parts = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) / step)));
  Stroke stroke;
  for (int i = 0; i <= parts; ++i) stroke.points.push_back(centre + radius * turned_to(from + (to - from) * i / parts));
  stroke.curves = {{0, parts, centre, {radius, 0}, {0, radius}, from, to}};
  return stroke;
}

Fill dot_at(const Vec2& centre) {
  constexpr double radius = 0.625;  // mm
  constexpr int parts = 48;
  // Rows have many, and are tried in many places.
  static const std::vector<Vec2> all = directions(parts);
  Fill fill{{{}}};
  for (int i = 0; i < parts; ++i) fill.rings.front().push_back(centre + radius * all[static_cast<std::size_t>(i)]);
  return fill;
}

void add_line(PlacedDimension& dimension, const Vec2& from, const Vec2& to) {
  dimension.strokes.emplace_back().points = {from, to};
}

void add_crossable_line(PlacedDimension& dimension, const Vec2& from, const Vec2& to) {
  add_line(dimension, from, to);
  dimension.lines.push_back(line_box(from, to));
}

namespace {

double degrees_of(const TextPosition& at) { return portable_atan2(at.read.y, at.read.x) * 180 / std::numbers::pi; }

// From left to right, the first one at a place; all have the base line of the lower number, and other pieces are at
// half the height of stacks.
void add_pieces(PlacedDimension& dimension, const DimensionText& text, Vec2 left, const TextPosition& at,
                const DimensionStyle& style) {
  const Vec2 up = left_of(at.read);
  const double degrees = degrees_of(at);
  const auto add = [&](const std::string& words, const Vec2& place, double height) {
    dimension.texts.push_back({words, place, height, degrees, Align::left, "dimension"});
  };
  const double small = stacked_height(style);
  for (const TextPiece& piece : text.pieces) {
    const PieceWidth width = width_of(piece, style);
    check(width.all >= width.whole(), "a number is as wide as what is before its decimal sign, or wider");
    if (piece.is_stack()) {
      add(piece.upper, left + (width.whole() - width.upper) * at.read + (1 + between_stacked) * small * up, small);
      add(piece.lower, left + (width.whole() - width.lower) * at.read, small);
    } else {
      add(piece.upper, left + (style.height(text) - style.text) / 2 * up, style.text);
    }
    left += width.all * at.read;
  }
}

// Around a text of this size.
void add_frame(PlacedDimension& dimension, const TextPosition& at, const Vec2& size, const DimensionStyle& style) {
  constexpr double around = 0.25;  // heights of capitals: less than what is between a text and its dimension line
  const Vec2 up = left_of(at.read), half = size / 2.0 + around * style.text;
  const Vec2 middle = at.middle + (at.rise + size.y / 2) * up;
  std::vector<Vec2>& corners = dimension.strokes.emplace_back().points;
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1)})
    corners.push_back(middle + corner.x * half.x * at.read + corner.y * half.y * up);
}

// A text of this width, mm: dimensions have hundreds of places, and letters are slow to measure.
void set_measured_text(PlacedDimension& dimension, const DimensionText& text, double width, const TextPosition& at,
                       const DimensionStyle& style) {
  const Vec2 up = left_of(at.read);
  if (text.has_stack())
    add_pieces(dimension, text, at.middle + at.rise * up - width / 2 * at.read, at, style);
  else
    dimension.texts.push_back(
        {text.line(), at.middle + at.rise * up, style.text, degrees_of(at), Align::middle, "dimension"});
  const double height = style.height(text);
  if (text.framed) add_frame(dimension, at, {width, height}, style);
  dimension.text_boxes.push_back({at.middle + (at.rise + height / 2) * up,
                                  at.read,
                                  {width / 2 + air * style.text, height / 2 + air * style.text}});
  check(dimension.text_boxes.back().half.x > 0 && dimension.text_boxes.back().half.y > 0, "a text has a size");
}

}  // namespace

void set_text(PlacedDimension& dimension, const DimensionText& text, const TextPosition& at,
              const DimensionStyle& style) {
  set_measured_text(dimension, text, style.width(text), at, style);
}

void add_leader(PlacedDimension& dimension, const DimensionText& text, const ShoulderedLeader& leader,
                const DimensionStyle& style) {
  const auto& [tip, elbow, to_left] = leader;
  const double letters = style.width(text), width = letters + 2 * style.above();
  const Vec2 shoulder = elbow + Vec2(to_left ? -width : width, 0);
  dimension.strokes.emplace_back().points = {tip, elbow, shoulder};
  dimension.lines.push_back(line_box(tip, elbow));
  dimension.leaders.push_back({tip, elbow});
  set_measured_text(dimension, text, letters, {(elbow + shoulder) * 0.5, {1, 0}, style.above()}, style);
  // The box includes the shoulder, which no line should meet or run along.
  TurnedBox& box = dimension.text_boxes.back();
  const double below = style.above() + std::max(0.0, style.gap() / 2 - air * style.text);
  box.centre.y -= below / 2;
  box.half += Vec2(style.above(), below / 2);
  dimension.zones.push_back(box);
}

double sign_of_offset(const Vec2& across) {
  return (std::abs(across.y) > along_paper ? across.y > 0 : across.x > 0) ? 1 : -1;
}

double first_side(const Vec2& along) {
  const double upwards = sign_of_offset(left_of(along));
  return std::abs(along.y) > std::abs(along.x) ? upwards : -upwards;
}

}  // namespace epura::sheet
