// SPDX-License-Identifier: Apache-2.0
#include "annotations/callout_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

std::string with_own_signs(std::string text, const DimensionStyle& style) {
  constexpr std::array<std::array<std::string_view, 2>, 2> substitutes{{{"⌀", "Ø"}, {"⌒", "∩"}}};
  for (const auto& [sign, letter] : substitutes)
    if (!style.lettering.covers(std::string(sign)))
      if (const std::size_t at = text.find(sign); at != std::string::npos) text.replace(at, sign.size(), letter);
  return with_decimal_sign(with_repeats(std::move(text), style.notation), style.notation.sign);
}

namespace {

// In heights of capitals.
constexpr double frame_height = 2, padding = 0.5, between = 0.3, circle_radius = 0.75;
constexpr double target_radius = 2;
constexpr double symbol_unit = 0.085;  // of the numbers of symbols
constexpr double above_frame = 0.4;    // between a frame and the text above it
constexpr double line_step = 1.5;

/// Reads the numbers of a symbol.
class SymbolReader {
 public:
  SymbolReader(Callout& callout, const Vec2& centre, double height)
      : callout_(callout), centre_(centre), unit_(symbol_unit * height) {}

  void draw(std::string_view symbol) {
    const std::vector<std::string_view> words = split(symbol, ' ');
    for (std::size_t i = 0; i < words.size();) {
      const char kind = words[i++][0];
      const auto number = [&] {
        check(i < words.size(), "a symbol ends with a whole stroke");
        return *parse_number(words[i++]);
      };
      const auto point = [&] {
        const double x = number();
        return centre_ + unit_ * Vec2(x, number());
      };
      const Vec2 at = point();
      if (kind == 'm') callout_.strokes.emplace_back().points = {at};
      if (kind == 'l') callout_.strokes.back().points.push_back(at);
      if (kind == 'c') callout_.strokes.push_back(circle_at(at, unit_ * number()));
      if (kind == 'h') callout_.strokes.push_back(upper_half(at, unit_ * number()));
      if (kind == 'f') {
        const Vec2 second = point();
        callout_.fills.push_back({{{at, second, point()}}});
      }
    }
  }

 private:
  static Stroke upper_half(const Vec2& centre, double radius) {
    constexpr int parts = 24;
    Stroke stroke;
    for (int i = 0; i <= parts; ++i) stroke.points.push_back(centre + radius * turned_to(std::numbers::pi * i / parts));
    stroke.curves = {{0, parts, centre, {radius, 0}, {0, radius}, 0, std::numbers::pi}};
    return stroke;
  }

  Callout& callout_;
  Vec2 centre_;
  double unit_;
};

double width_of_symbol(const scene::FramePiece& piece, const DimensionStyle& style) {
  return piece.circled ? 2 * circle_radius * style.text
                       : style.lettering.width(with_own_signs(piece.text, style), style.text);
}

// Adds a compartment at the right end of a frame; returns its right side.
double add_cell(Callout& callout, const scene::FrameCell& cell, double left, const DimensionStyle& style) {
  const double h = style.text;
  double inner = 0;
  for (const scene::FramePiece& piece : cell) inner += width_of_symbol(piece, style) + (inner > 0 ? between * h : 0);
  const double width = std::max(inner + 2 * padding * h, frame_height * h);
  double x = left + (width - inner) / 2;
  for (const scene::FramePiece& piece : cell) {
    const double own = width_of_symbol(piece, style), middle = x + own / 2;
    callout.texts.push_back({with_own_signs(piece.text, style), {middle, h / 2}, h, 0, Align::middle, "tolerance"});
    if (piece.circled) callout.strokes.push_back(circle_at({middle, h}, circle_radius * h));
    x += own + between * h;
  }
  callout.strokes.push_back(line({left + width, 0}, {left + width, frame_height * h}));
  return left + width;
}

constexpr double short_arm = 1.4, min_arm = 3;
const double slope = 1 / std::sqrt(3.0);  // arms are at 60 degrees to the surface

// The basic symbol in brackets: other symbols on the sheet say what else is required. Returns the right end.
double add_others(Callout& callout, double left, const DimensionStyle& style) {
  constexpr double bracket = 2;
  const double h = style.text, wide = style.lettering.width("(", bracket * h);
  const Vec2 tip(left + h + wide + short_arm * slope * h, 0);
  callout.strokes.emplace_back().points = {tip + short_arm * h * Vec2(-slope, 1), tip,
                                           tip + min_arm * h * Vec2(slope, 1)};
  const double right = tip.x + min_arm * slope * h + wide;
  callout.texts.push_back({"(", {left + h, h / 2}, bracket * h, 0, Align::left, "texture"});
  callout.texts.push_back({")", {right, h / 2}, bracket * h, 0, Align::right, "texture"});
  return right;
}

}  // namespace

double height_of(const scene::ToleranceFrame& frame) {
  return frame_height * static_cast<double>(1 + frame.also.size()) + (frame.above.empty() ? 0 : above_frame + 1);
}

namespace {

// One frame, with its lower left corner at the origin. Its symbol is that of so many frames, of which it is the upper
// one; 0: the symbol is that of a frame above. Sets the width.
Callout single_frame(const scene::ToleranceFrame& frame, int rows, const DimensionStyle& style) {
  const double h = style.text, height = frame_height * h, below = (rows - 1) * height;
  Callout callout;
  if (rows > 0) SymbolReader(callout, {h, h - below / 2}, h).draw(scene::row_of(frame.characteristic).symbol);
  if (rows > 0) callout.strokes.push_back(line({height, 0}, {height, height}));
  double right = add_cell(callout, frame.zone, height, style);
  for (const scene::FrameCell& datum : frame.datums) right = add_cell(callout, datum, right, style);
  // The right side is that of the outline.
  callout.strokes.back() = outline({{rows == 1 ? 0 : height, 0}, {right, height}});
  if (rows > 1) callout.strokes.push_back(outline({{0, -below}, {height, height}}));
  callout.size = {right, height};
  return callout;
}

void add_above(Callout& callout, Callout frame, double bottom) {
  check(bottom >= 0, "frames stand on the first one");
  const Vec2 up(0, bottom);
  for (Text& text : frame.texts) {
    text.at += up;
    callout.texts.push_back(std::move(text));
  }
  for (Stroke& stroke : frame.strokes) {
    for (Vec2& p : stroke.points) p += up;
    for (drawing::CurvePart& curve : stroke.curves) curve.centre += up;
    callout.strokes.push_back(std::move(stroke));
  }
  for (Fill& fill : frame.fills) {
    for (std::vector<Vec2>& ring : fill.rings)
      for (Vec2& p : ring) p += up;
    callout.fills.push_back(std::move(fill));
  }
  callout.size.x = std::max(callout.size.x, frame.size.x);
}

// What was added to a callout for a frame, as an object: one with all that share its symbol.
void add_object(Callout& callout, const scene::ToleranceFrame& frame, double bottom, const DimensionStyle& style) {
  if (!frame.is_composite) {
    ToleranceObject& object = callout.tolerances.emplace_back();
    object.at = {0, bottom + frame_height / 2 * style.text};
    object.text_height = style.text;
    if (callout.tolerances.size() > 1) {
      const ToleranceObject& last = callout.tolerances[callout.tolerances.size() - 2];
      object.strokes.begin = last.strokes.end;
      object.fills.begin = last.fills.end;
      object.texts.begin = last.texts.end;
    }
  }
  ToleranceObject& object = callout.tolerances.back();
  FrameRow& row = object.rows.emplace_back(FrameRow{frame.characteristic, {frame.zone}});
  row.cells.insert(row.cells.end(), frame.datums.begin(), frame.datums.end());
  for (scene::FrameCell& cell : row.cells)
    for (scene::FramePiece& piece : cell) piece.text = with_own_signs(std::move(piece.text), style);
  object.strokes.end = callout.strokes.size();
  object.fills.end = callout.fills.size();
  object.texts.end = callout.texts.size();
  check(object.strokes.begin <= object.strokes.end && object.texts.begin <= object.texts.end,
        "the ink of a frame follows that of the one before");
}

}  // namespace

// Several frames of one feature stand below each other; the leader leads to the first one.
Callout tolerance_frame(const scene::ToleranceFrame& frame, const DimensionStyle& style) {
  const double h = style.text, height = frame_height * h;
  const double bottom = height * static_cast<double>(frame.also.size());
  Callout callout;
  callout.form = LeaderForm::landing;
  callout.attach = bottom + h;
  callout.all_around = frame.all_around;
  const auto rows_from = [&frame](std::size_t first) {
    int rows = 1;
    while (first < frame.also.size() && frame.also[first].is_composite) ++first, ++rows;
    return rows;
  };
  add_above(callout, single_frame(frame, rows_from(0), style), bottom);
  add_object(callout, frame, bottom, style);
  for (std::size_t i = 0; i < frame.also.size(); ++i) {
    const scene::ToleranceFrame& also = frame.also[i];
    const double below = bottom - height * static_cast<double>(i + 1);
    add_above(callout, single_frame(also, also.is_composite ? 0 : rows_from(i + 1), style), below);
    add_object(callout, also, below, style);
  }
  if (!frame.above.empty()) {
    callout.texts.push_back(
        {with_own_signs(frame.above, style), {0, bottom + height + above_frame * h}, h, 0, Align::left, "tolerance"});
    callout.size.x = std::max(callout.size.x, style.lettering.width(frame.above, h));
  }
  callout.size.y = height_of(frame) * h;
  check(callout.size.y > bottom, "frames below the first one are within");
  return callout;
}

double height_of(const scene::DatumFeature&) { return frame_height; }

Callout datum_frame(const scene::DatumFeature& datum, const DimensionStyle& style) {
  const double h = style.text, height = frame_height * h;
  const double width = std::max(height, style.lettering.width(datum.letter, h) + 2 * padding * h);
  Callout callout;
  callout.form = LeaderForm::datum;
  callout.attach = h;
  callout.size = {width, height};
  callout.strokes.push_back(outline({{0, 0}, callout.size}));
  callout.texts.push_back({datum.letter, {width / 2, h / 2}, h, 0, Align::middle, "tolerance"});
  return callout;
}

double height_of(const scene::DatumTarget&) { return 2 * target_radius; }

Callout target_symbol(const scene::DatumTarget& target, const DimensionStyle& style) {
  const double h = style.text, radius = target_radius * h;
  const std::string size = with_own_signs(target.size, style);
  const Vec2 centre(radius, radius);
  Callout callout;
  callout.form = LeaderForm::landing;
  callout.attach = radius;
  callout.size = {2 * radius, 2 * radius};
  callout.area = target;
  callout.strokes.push_back(circle_at(centre, radius));
  callout.strokes.push_back(line({0, radius}, {2 * radius, radius}));
  const double below = radius - (1 + between) * h, above = radius + between * h;
  callout.texts.push_back({target.label, {radius, below}, h, 0, Align::middle, "tolerance"});
  check(below >= 0 && radius > 0, "a label is within its circle");
  if (size.empty()) return callout;
  // The upper corners of the text are within the circle, or it stands beside it.
  const double width = style.lettering.width(size, h), rise = above + h - radius;
  if (rise * rise + width * width / 4 <= radius * radius) {
    callout.texts.push_back({size, {radius, above}, h, 0, Align::middle, "tolerance"});
    return callout;
  }
  const double left = 2 * radius + padding * h;
  callout.texts.push_back({size, {left, above}, h, 0, Align::left, "tolerance"});
  callout.size.x = left + width;
  return callout;
}

// ISO 1302, annex A: the short arm is 1.4 h high, the long one 3 h or as high as its texts.
double height_of(const scene::SurfaceTexture& texture) {
  const double lines = static_cast<double>(texture.lines.size());
  const double arm = std::max(min_arm, 2 * short_arm + std::max(lines - 1, 0.0) * line_step);
  return arm + (texture.process.empty() ? 0 : above_frame + 1);
}

Callout texture_symbol(const scene::SurfaceTexture& texture, const DimensionStyle& style) {
  const double h = style.text;
  const double low = short_arm * h, half = low * slope;
  const double high = height_of(texture) * h - (texture.process.empty() ? 0 : (above_frame + 1) * h);
  const Vec2 tip(half, 0), left(0, low), right(2 * half, low), top = tip + high * Vec2(slope, 1);
  Callout callout;
  callout.form = LeaderForm::reference;
  callout.strokes.emplace_back().points = {left, tip, top};
  if (texture.removal == MaterialRemoval::required) callout.strokes.push_back(line(left, right));
  // A circle that touches both arms, and the height of the short one.
  if (texture.removal == MaterialRemoval::prohibited)
    callout.strokes.push_back(circle_at({half, low * 2 / 3}, low / 3));
  double width = top.x;
  const double text_left = top.x + 0.2 * h;
  double base = high - (above_frame + 1) * h;
  for (const std::string& words : texture.lines) {
    const std::string written = with_own_signs(words, style);
    callout.texts.push_back({written, {text_left, base}, h, 0, Align::left, "texture"});
    width = std::max(width, text_left + style.lettering.width(written, h));
    base -= line_step * h;
  }
  if (!texture.process.empty()) {
    callout.texts.push_back({texture.process, {text_left, high + above_frame * h}, h, 0, Align::left, "texture"});
    width = std::max(width, text_left + style.lettering.width(texture.process, h));
  }
  if (width > top.x) callout.strokes.front().points.push_back({width, high});
  if (texture.others) width = add_others(callout, width, style);
  check(width >= top.x, "a symbol is as wide as its arms");
  callout.size = {width, height_of(texture) * h};
  return callout;
}

}  // namespace epura::sheet
