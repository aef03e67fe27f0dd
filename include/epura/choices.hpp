// SPDX-License-Identifier: Apache-2.0
// What one chooses among in a drawing.
#pragma once

namespace epura {

/// Unit of length of a model.
enum class Unit { mm, in, m };

/// Axis that points up in a model.
enum class UpAxis { z, y };

/// Whose edges are drawn: of the faces of the part that are recognised behind the triangles, or of the mesh alone.
enum class Surfaces { automatic, mesh };

enum class HiddenLines { none, dashed, solid };

/// What the visible lines of a model are: of the part itself (wide, continuous), of one that stays in the background
/// (narrow, continuous), or of a neighbouring part (narrow, long-dashed double-dotted; ISO 128-2, type 05.1).
enum class LineRole { visible, narrow, neighbour };

/// Which edges of a model are drawn.
struct EdgeKinds {
  bool contour = true;       ///< where the surface turns away from the viewer
  bool crease = true;        ///< where two faces meet at an angle
  bool boundary = true;      ///< where a surface ends
  bool intersection = true;  ///< where faces go through each other
  bool tangent = false;      ///< between a flat face and a curved one that goes on from it
  bool smooth = false;       ///< all other edges of the mesh

  bool operator==(const EdgeKinds&) const = default;
};

enum class Orientation { landscape, portrait };

/// Where views stand: ISO 5456-2 (first angle) or ASME Y14.3 (third angle).
enum class ProjectionAngle { first, third };

/// What surrounds a drawing: `plain` is the frame of the drawing area, `full` has centring marks, grid references,
/// trimming marks and the title block, too (ISO 5457, ISO 7200). `automatic`: full for several views, and where a field
/// of the title block other than the title is given; otherwise none.
enum class FrameKind { automatic, none, plain, full };

enum class DimensionType { linear, aligned, angular, radius, diameter, overall };

/// Of linear dimensions on paper, of overall ones in the world: along x, z and y.
enum class DimensionDirection { horizontal, vertical, width, height, depth };

/// What an edge is that a line shows, in order of priority where several fall on one line of the page. `section` is the
/// outline of a cut face.
enum class EdgeKind : unsigned char { contour, boundary, crease, intersection, section, tangent, smooth };

/// Lettering of SVG: outlines look the same everywhere; text can be searched, and needs the font to look right.
enum class SvgText { outlines, text };

}  // namespace epura
