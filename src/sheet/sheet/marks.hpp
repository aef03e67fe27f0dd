// SPDX-License-Identifier: Apache-2.0
// The elements of dimensions on paper: lines, arrows, text. ISO 129-1.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/portable_math.hpp"
#include "base/vec.hpp"
#include "sheet/boxes.hpp"
#include "sheet/dimension_text.hpp"
#include "sheet/lettering.hpp"
#include "sheet/notation.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Distances from the outline to the first dimension line, and from one to the next, mm.
inline constexpr double first_dimension = 10;
constexpr double dimension_step(double text_height) { return 4.5 + text_height; }

/// Sizes of dimensions, mm.
struct DimensionStyle {
  const Lettering& lettering;
  double line;        ///< width of the narrow lines
  double text = 3.5;  ///< height of capitals
  Notation notation{};

  [[nodiscard]] double arrow() const { return text; }          ///< its length; the angle of the tip is 20 degrees
  [[nodiscard]] double gap() const { return 8 * line; }        ///< between the outline and an extension line
  [[nodiscard]] double overshoot() const { return 8 * line; }  ///< of an extension line past the dimension line
  [[nodiscard]] double above() const { return 0.3 * text; }    ///< between the dimension line and its text
  [[nodiscard]] double width(const DimensionText& written) const;
  [[nodiscard]] double height(const DimensionText& written) const;
};

/// An end of a dimension line, in line with which something may stand.
struct DimensionEnd {
  Vec2 point, outwards;        ///< on the extension line; the direction has length 1
  std::optional<int> arrow{};  ///< number of an arrow outside that it would replace
};

/// The oblique line of a leader, from the arrow to the bend before the text.
struct LeaderLine {
  Vec2 tip, elbow;
  double before = 0;  ///< mm from the end of its arrow to the tip, where it may touch what it means
};

/// A dimension as it would be drawn, and the area that it takes up on paper.
struct PlacedDimension {
  std::vector<Stroke> strokes;
  std::vector<Fill> arrows;
  std::vector<Text> texts;                 ///< its pieces
  std::vector<TurnedBox> text_boxes{};     ///< with a little space around them
  std::vector<TurnedBox> zones;            ///< of the dimension line and the text, for their exclusive use
  std::vector<TurnedBox> lines;            ///< extension lines and leaders, which may be crossed
  std::vector<LeaderLine> leaders{};       ///< those of the lines that are leaders
  std::vector<DimensionEnd> ends{};        ///< of a single dimension line, where no text stands
  std::vector<DimensionObject> objects{};  ///< shapes, points and angles of what it consists of; of several, also
                                           ///< their texts
};

inline Vec2 turned_to(double angle) { return {portable_cos(angle), portable_sin(angle)}; }

/// The one of two opposite directions in which a text is read: from the bottom or from the right.
Vec2 reading_direction(const Vec2& along);

/// `direction` points to the tip and has length 1.
Fill arrow_at(const Vec2& tip, const Vec2& direction, const DimensionStyle& style);

/// A circle as a stroke of this many straight parts, which remain one curve.
Stroke circle_at(const Vec2& centre, double radius, int parts = 48);

/// A dot at the end of a leader.
Fill dot_at(const Vec2& centre);

/// An arc from one angle to another, as a stroke that is one curve.
Stroke arc_at(const Vec2& centre, double radius, double from, double to);

/// Adds a stroke between two points.
void add_line(PlacedDimension& dimension, const Vec2& from, const Vec2& to);

/// The same for an extension line or leader.
void add_crossable_line(PlacedDimension& dimension, const Vec2& from, const Vec2& to);

/// Position of a dimension's text.
struct TextPosition {
  Vec2 middle;  ///< a point on the line along which the text is read
  Vec2 read;    ///< the direction of that line, of length 1
  double rise;  ///< of the text above the line
};
void set_text(PlacedDimension& dimension, const DimensionText& text, const TextPosition& at,
              const DimensionStyle& style);

/// Adds a leader from `tip`, which bends at `elbow` into a shoulder to the right, or to the left, and the text on it.
struct ShoulderedLeader {
  Vec2 tip, elbow;
  bool to_left;
};
void add_leader(PlacedDimension& dimension, const DimensionText& text, const ShoulderedLeader& leader,
                const DimensionStyle& style);

inline constexpr double along_paper = 1e-6;  ///< of a unit vector, across a side of the paper: parallel to it

/// 1 if `across` points upwards, or to the right; otherwise -1.
double sign_of_offset(const Vec2& across);

/// The side on which a dimension line in a direction is by preference, below or on the right: 1 to its left, or -1.
double first_side(const Vec2& along);

}  // namespace epura::sheet
