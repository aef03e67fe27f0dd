// SPDX-License-Identifier: Apache-2.0
// Strokes as DXF shapes: polylines with arcs, and separate curves.
#pragma once

#include <variant>
#include <vector>

#include "output/vector_options.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// A corner and the bulge of the line that begins there: the tangent of a quarter of its arc's angle, positive if
/// counterclockwise; 0 for a straight line.
struct BulgedCorner {
  Vec2 at;
  double bulge = 0;
};

struct BulgedLine {
  std::vector<BulgedCorner> corners;
  bool closed = false;
};

/// An elliptical arc, counterclockwise from one angle to another: centre + cos(a) major + sin(a) minor, where minor =
/// ratio * major turned left by a right angle. Radians; a circle has ratio 1.
struct EllipseArc {
  Vec2 centre, major;
  double ratio;
  double from, to;

  /// Whether it is a full turn.
  [[nodiscard]] bool whole() const;
};

using DxfShape = std::variant<BulgedLine, EllipseArc>;

/// A stroke with arcs instead of its short straight pieces that lie on one circle within the width of a hair: LibreCAD
/// begins dashes anew at each corner, so that dashed circles of short pieces are continuous there.
sheet::Stroke with_arcs(sheet::Stroke stroke);

/// The shapes of a stroke in order, without repetitions. As bulges: circular arcs among straight lines become bulges;
/// elliptical arcs and strokes that consist of one arc become separate shapes. As entities: circular arcs become shapes
/// that begin and end at points of the stroke, and elliptical arcs straight pieces.
std::vector<DxfShape> dxf_shapes(const sheet::Stroke& stroke, DxfArcs arcs);

}  // namespace epura::output
