// SPDX-License-Identifier: Apache-2.0
// Measures dimensions: the true value in the world, and the position of the measured geometry on paper.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/angle.hpp"
#include "base/vec.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/dimension_text.hpp"
#include "sheet/notation.hpp"
#include "sizes/anchors.hpp"

namespace epura::sheet {

/// A distance along a straight dimension line. Millimetres on paper.
struct MeasuredLength {
  Vec2 from, to;                                  ///< where the extension lines begin
  Vec2 along;                                     ///< direction of the dimension line; length 1
  Vec2 extension;                                 ///< direction of the extension lines, to either side; length 1
  std::optional<std::array<Vec2, 2>> opposite{};  ///< where they begin if the dimension line is above or on the left
  std::optional<bool> open{};  ///< only one end is shown, as in half views: true if `to` is where the line breaks off
  double value = 0;            ///< in the world, mm
  bool is_diameter = false;    ///< of a circle seen edge-on: the extension lines begin along its outline
};

/// Lengths from one place to others along one direction, arranged together. Millimetres on paper.
struct MeasuredRow {
  std::vector<Vec2> places;          ///< where extension lines begin, in order along the direction
  std::size_t origin = 0;            ///< number of the place from which lengths are measured
  Vec2 along;                        ///< direction in which they are read: right or up; length 1
  std::vector<DimensionText> texts;  ///< of each place, its length; of a chain, the length to the next one
  DimensionArrangement arrangement;
  std::optional<std::vector<Vec2>> opposite{};  ///< the places for dimension lines above or on the left
  std::vector<double> values{};                 ///< of each text, mm
  std::optional<bool> above{};                  ///< whether it must be above or on the left; otherwise on either side

  [[nodiscard]] double size() const { return glm::dot(places.back() - places.front(), along); }
};

/// A corner, and the ends of its legs, relative to it.
struct CornerOnPaper {
  Vec2 at;
  std::array<Vec2, 2> legs;
};

struct MeasuredAngle {
  Vec2 corner;
  std::array<Vec2, 2> legs;  ///< their ends, relative to the corner
  std::optional<double>
      arc{};  ///< if the length of an arc that begins at the first leg is measured: its sweep, radians
  std::optional<CornerOnPaper> equal{};  ///< another corner with this angle, at which it may be instead
};

/// A line along a circle that a view draws: its ends from the centre, in lengths of the spokes.
struct LineOfCircle {
  std::array<Vec2, 2> ends;
  bool visible;
};

/// A circle or an arc seen in true shape or, in an axonometric view, as an ellipse.
struct MeasuredCircle {
  Vec2 centre;
  double radius;
  double first, sweep;    ///< radians: where an arc begins and its extent; 2 pi for a whole circle
  bool is_radius;         ///< whether the radius is measured; otherwise the diameter
  bool is_label = false;  ///< whether the text is only a name beside the circle
  double value = 0;       ///< in the world, mm
  std::optional<std::array<Vec2, 2>> spokes{};  ///< of an ellipse: images of two perpendicular spokes
  Vec3 place{0}, axis{0};                       ///< in the world: its centre, and the direction of its axis; length 1
  std::vector<LineOfCircle> lines{};            ///< as of lines_along

  [[nodiscard]] bool is_whole() const { return std::abs(sweep) >= full_turn; }
  /// A direction from the centre in lengths of the spokes: 1 where it meets the circle.
  [[nodiscard]] Vec2 in_spokes(const Vec2& off) const {
    if (!spokes) return off / radius;
    const auto& [u, v] = *spokes;
    return Vec2(cross(off, v), cross(u, off)) / cross(u, v);
  }
  [[nodiscard]] Vec2 of_spokes(const Vec2& p) const {
    return spokes ? p.x * (*spokes)[0] + p.y * (*spokes)[1] : radius * p;
  }
  /// From the centre to the circle, along a unit vector.
  [[nodiscard]] double reach(const Vec2& direction) const {
    return spokes ? 1 / glm::length(in_spokes(direction)) : radius;
  }
};

struct MeasuredDimension {
  std::variant<MeasuredLength, MeasuredRow, MeasuredAngle, MeasuredCircle> form;
  DimensionText text;  ///< as written; of a row, all texts
  std::optional<double> offset;
  std::string name{};                   ///< by which datums and frames refer to it
  std::vector<MeasuredCircle> equal{};  ///< of equal features, where it may be instead
};

/// The view must show true measures: lengths and angles must lie parallel to its plane; in an orthographic view,
/// `linear` measures between planes perpendicular to the paper, and `aligned` may follow a world axis that the view
/// shortens (the extension lines then follow another axis). Throws Error{input} with the reason if a view shows no true
/// measures, as in perspective. ISO 129-1.
MeasuredDimension measure(const drawing::ViewDrawing& drawing, const AnchoredDimension& dimension,
                          const Notation& notation);

/// Whether an arrow with this tip ends at what is measured, or an extension line of it.
bool ends_at(const MeasuredLength& length, const Vec2& tip);
bool ends_at(const MeasuredRow& row, const Vec2& tip);
bool ends_at(const MeasuredAngle& angle, const Vec2& tip);
bool ends_at(const MeasuredCircle& circle, const Vec2& tip);

/// What decides on the places that a dimension may have, beside its text: equal for those that measure the same. Not of
/// rows.
std::vector<double> places_of(const MeasuredDimension& dimension);

}  // namespace epura::sheet
