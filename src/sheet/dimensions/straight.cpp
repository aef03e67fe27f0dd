// SPDX-License-Identifier: Apache-2.0
#include "dimensions/straight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"

namespace epura::sheet {

namespace {

constexpr double no_length = 1e-6;  // mm

double span_of(const MeasuredLength& length) { return std::abs(glm::dot(length.to - length.from, length.along)); }

// Of a text and the space around it, above the dimension line.
double top_of(const DimensionText& text, const DimensionStyle& style) { return 2 * style.above() + style.height(text); }

// How far extension lines reach over the line beside a text, to its right if this is positive.
double reach_over(double lean, const DimensionText& text, const DimensionStyle& style) {
  return lean * top_of(text, style);
}

// What a text between extension lines leaves of a dimension line; negative if it does not fit.
double room_beside(double span, double lean, const DimensionText& text, const DimensionStyle& style) {
  return span - std::abs(reach_over(lean, text, style)) - style.width(text) - style.above();
}

double lean_of(const MeasuredLength& length) {
  const Vec2 read = reading_direction(length.along);
  return glm::dot(length.extension, read) / glm::dot(length.extension, left_of(read));
}

// The point where the extension line through an anchor meets the dimension line.
Vec2 foot_of(const MeasuredLength& length, const Vec2& anchor, double distance) {
  const Vec2 across = left_of(length.along);
  const double rest = distance - glm::dot(anchor - length.from, across);
  return anchor + rest / glm::dot(length.extension, across) * length.extension;
}

// The extent of a part of the dimension line, mm from its lower end.
struct ValueExtent {
  double begin, end;
};

// The position of the text on the line, and the extent of the line including the parts that lead to the text or carry
// arrows.
struct Layout {
  bool outward;  // arrows are between the extension lines
  ValueExtent line;
  double text_middle;
};

Layout layout_of_arrows(const DimensionLine& base, const DimensionStyle& style) {
  const bool outward = base.span >= arrows_inside * style.arrow();
  const double tail = outward ? 0 : 2 * style.arrow();
  return {outward, {-tail, base.span + tail}, base.span / 2};
}

Layout layout_beside(const DimensionLine& base, const DimensionText& text, const TextBeside& beside,
                     const DimensionStyle& style) {
  Layout layout = layout_of_arrows(base, style);
  const bool behind = beside.at_high;
  const double reach = reach_over(base.lean, text, style), width = style.width(text);
  const double lead = (layout.outward ? 0 : style.arrow()) + 2 * style.above() + beside.farther +
                      std::max(behind ? reach : -reach, 0.0);
  const double past = lead + width + style.above();
  layout.text_middle = behind ? base.span + lead + width / 2 : -lead - width / 2;
  (behind ? layout.line.end : layout.line.begin) =
      behind ? std::max(layout.line.end, base.span + past) : std::min(layout.line.begin, -past);
  return layout;
}

Layout layout_of(const DimensionLine& base, const DimensionText& text, int place, const DimensionStyle& style) {
  const double room = room_beside(base.span, base.lean, text, style);
  if (room < 0) return layout_beside(base, text, {place == 0, 0}, style);
  constexpr std::array<double, text_places> shifts{0, 0.5, -0.5, 1, -1};
  Layout layout = layout_of_arrows(base, style);
  layout.text_middle += reach_over(base.lean, text, style) / 2 + shifts[std::size_t(place)] * room / 2;
  return layout;
}

double degrees_of(const Vec2& direction) { return portable_atan2(direction.y, direction.x) * 180 / std::numbers::pi; }

DimensionObject object_of(const MeasuredLength& length, const std::array<Vec2, 2>& ends, const DimensionLine& base) {
  DimensionObject object{DimensionShape::linear, {ends[0], ends[1], base.high}, degrees_of(base.read)};
  object.value = length.value;
  const Vec2 leaning = reading_direction(length.extension);
  if (std::abs(glm::dot(leaning, base.read)) > 1e-9) object.oblique = degrees_of(leaning);
  return object;
}

}  // namespace

void add_extension_line(PlacedDimension& dimension, const Vec2& anchor, const Vec2& foot, const DimensionStyle& style) {
  const double reach = glm::length(foot - anchor);
  if (reach <= no_length) return;
  const Vec2 direction = (foot - anchor) / reach;
  const double gap = reach > 2 * style.gap() ? style.gap() : 0;
  add_crossable_line(dimension, anchor + gap * direction, foot + style.overshoot() * direction);
}

namespace {

// The line and its arrows, with a zone of this height above it.
void add_line_with_arrows(PlacedDimension& dimension, const DimensionLine& line, const Layout& layout, double top,
                          const DimensionStyle& style) {
  const auto& [low, high, read, span, low_open, high_open, lean] = line;
  check(layout.line.begin <= 0 && layout.line.end >= span, "a dimension line reaches from end to end");
  const Vec2 begin = low + layout.line.begin * read, end = low + layout.line.end * read;
  add_line(dimension, begin, end);
  const auto end_at = [&](const Vec2& point, const Vec2& outwards, bool has_text) {
    const int arrow = static_cast<int>(dimension.arrows.size());
    dimension.arrows.push_back(arrow_at(point, layout.outward ? outwards : -outwards, style));
    if (!has_text) dimension.ends.push_back({point, outwards, layout.outward ? std::nullopt : std::optional(arrow)});
  };
  if (!low_open) end_at(low, -read, layout.text_middle < 0);
  if (!high_open) end_at(high, read, layout.text_middle > span);
  const double below = style.above();
  dimension.zones.push_back({(begin + end) * 0.5 + (top - below) / 2 * left_of(read),
                             read,
                             {(layout.line.end - layout.line.begin) / 2, (top + below) / 2}});
}

void add_with_text(PlacedDimension& dimension, const DimensionLine& line, const DimensionText& text,
                   const Layout& layout, const DimensionStyle& style) {
  // From the arrows below the line to the top of the text.
  add_line_with_arrows(dimension, line, layout, top_of(text, style), style);
  set_text(dimension, text, {line.low + layout.text_middle * line.read, line.read, style.above()}, style);
}

// The dimension line of a length, and its extension lines in `dimension`.
DimensionLine begin_dimension(PlacedDimension& dimension, const MeasuredLength& length, double distance,
                              const DimensionStyle& style) {
  const Vec2 read = reading_direction(length.along);
  Vec2 low = length.from, high = length.to;
  const bool swaps = glm::dot(high - low, read) < 0;
  if (swaps) std::swap(low, high);
  // An end at which the dimension line breaks off.
  const bool low_open = length.open && *length.open == swaps, high_open = length.open && *length.open != swaps;
  const DimensionLine line{foot_of(length, low, distance),
                           foot_of(length, high, distance),
                           read,
                           span_of(length),
                           low_open,
                           high_open,
                           lean_of(length)};
  check(line.span >= 0, "a length is not negative");
  if (!low_open) add_extension_line(dimension, low, line.low, style);
  if (!high_open) add_extension_line(dimension, high, line.high, style);
  if (!length.open) dimension.objects = {object_of(length, {low, high}, line)};
  return line;
}

}  // namespace

void add_dimension_line(PlacedDimension& dimension, const DimensionLine& line, const DimensionText& text, int place,
                        const DimensionStyle& style) {
  add_with_text(dimension, line, text, layout_of(line, text, place, style), style);
}

bool fits_inside(const MeasuredLength& length, const DimensionText& text, const DimensionStyle& style) {
  return room_beside(span_of(length), lean_of(length), text, style) >= 0;
}

PlacedDimension straight_dimension(const MeasuredLength& length, const DimensionText& text, double distance, int place,
                                   const DimensionStyle& style) {
  PlacedDimension dimension;
  const DimensionLine line = begin_dimension(dimension, length, distance, style);
  add_dimension_line(dimension, line, text, place, style);
  return dimension;
}

PlacedDimension straight_dimension_beside(const MeasuredLength& length, const DimensionText& text, double distance,
                                          const TextBeside& beside, const DimensionStyle& style) {
  PlacedDimension dimension;
  const DimensionLine line = begin_dimension(dimension, length, distance, style);
  add_with_text(dimension, line, text, layout_beside(line, text, beside, style), style);
  return dimension;
}

PlacedDimension straight_dimension_with_leader(const MeasuredLength& length, const DimensionText& text, double distance,
                                               const Vec2& leader, const DimensionStyle& style) {
  PlacedDimension dimension;
  const DimensionLine line = begin_dimension(dimension, length, distance, style);
  add_line_with_arrows(dimension, line, layout_of_arrows(line, style), style.above(), style);
  const Vec2 middle = (line.low + line.high) / 2.0;
  add_leader(dimension, text, {middle, middle + leader, leader.x < 0}, style);
  return dimension;
}

}  // namespace epura::sheet
