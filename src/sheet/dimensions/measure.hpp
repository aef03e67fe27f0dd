// SPDX-License-Identifier: Apache-2.0
// Measures dimensions: the true value in the world, and the position of the measured geometry on paper.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "base/vec.hpp"
#include "drawing/drawing.hpp"
#include "sheet/dimensions/anchors.hpp"

namespace epura::sheet {

/// A distance along a straight dimension line. Millimetres of paper.
struct MeasuredLength {
  Vec2 from, to;   ///< where the extension lines begin
  Vec2 along;      ///< of the dimension line; length 1
  Vec2 extension;  ///< of the extension lines, to either side; length 1
};

struct MeasuredAngle {
  Vec2 corner;
  std::array<Vec2, 2> legs;  ///< ends, as seen from the corner
};

/// A circle or an arc seen in its true form.
struct MeasuredCircle {
  Vec2 centre;
  double radius;
  double first, sweep;  ///< radians: where an arc begins and how far it goes; 2 pi for a whole circle
  bool is_radius;       ///< what is measured; otherwise the diameter
};

struct MeasuredDimension {
  std::variant<MeasuredLength, MeasuredAngle, MeasuredCircle> form;
  std::string text;  ///< as it is written
  std::optional<double> offset;
};

/// The view must show true measures: lengths and angles those that lie parallel to its plane; in an orthographic view
/// `linear` measures between planes across the paper, and `aligned` may follow a world axis that the view shortens
/// (the extension lines then follow another one). Throws Error{input} with the reason where a view shows none, as in
/// perspective. Values have 2 decimals at most. `diameter` is the sign before diameters. ISO 129-1.
MeasuredDimension measure(const drawing::ViewDrawing& drawing, const AnchoredDimension& dimension,
                          const std::string& diameter);

}  // namespace epura::sheet
