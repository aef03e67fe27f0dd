// SPDX-License-Identifier: Apache-2.0
// Strokes as DXF shapes: polylines with arcs, and separate curves.
#pragma once

#include <variant>
#include <vector>

#include "sheet/sheet.hpp"

namespace epura::output {

/// A corner and the bulge of the line that begins there: the tangent of a quarter of its arc's angle, positive
/// counterclockwise; 0 for a straight line.
struct BulgedCorner {
  Vec2 at;
  double bulge = 0;
};

struct BulgedLine {
  std::vector<BulgedCorner> corners;
  bool closed = false;
};

/// An ellipse, run through counterclockwise from one angle to another: centre + cos(a) major + sin(a) minor, where
/// minor = ratio * major turned by a right angle. Radians; a circle has ratio 1.
struct EllipseArc {
  Vec2 centre, major;
  double ratio;
  double from, to;

  /// Whether it goes all the way round.
  [[nodiscard]] bool whole() const;
};

using DxfShape = std::variant<BulgedLine, EllipseArc>;

/// The shapes of a stroke in its order, without repetitions: arcs of circles among straight lines are bulges; arcs of
/// ellipses and strokes consisting of one arc are separate shapes.
std::vector<DxfShape> dxf_shapes(const sheet::Stroke& stroke);

}  // namespace epura::output
