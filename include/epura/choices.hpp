// SPDX-License-Identifier: Apache-2.0
// Choices for a drawing.
#pragma once

namespace epura {

/// Unit of length of a model.
enum class Unit { mm, in, m };

/// Axis of a model that points up.
enum class UpAxis { z, y };

/// Source of edges: the recognised faces of the part (where there are any), or the mesh alone.
enum class Surfaces { automatic, mesh };

/// Which requirements of a model file are drawn: all, dimensions only, or geometric tolerances with their datums only.
enum class Pmi { all, dimensions, tolerances, none };

enum class HiddenLines { none, dashed, solid };

/// Pattern of cut faces: none (outline only), general (equal lines; ANSI31), steel (pairs of lines; ANSI32), bronze
/// (continuous and dashed lines in turn; ANSI33), nonmetal (crossing lines; ANSI37), or solid (filled).
enum class HatchPattern { none, general, steel, bronze, nonmetal, solid };

/// Style of the visible lines of a model: the part itself (wide, continuous; wires and tangent edges narrow), a
/// background part (narrow, continuous), an adjacent part (narrow, long-dashed double-dotted; ISO 128-2, type 05.1), or
/// one whose wires and tangent edges are wide, too.
enum class LineRole { visible, narrow, neighbour, wide };

/// Layers of a view: one for each role of lines, or one for each role of lines of each body.
enum class LayersBy { role, body };

/// Which edges of a model are drawn.
struct EdgeKinds {
  bool contour = true;       ///< where a surface turns away from the viewer
  bool crease = true;        ///< where two faces meet at an angle
  bool boundary = true;      ///< where a surface ends
  bool intersection = true;  ///< where faces cross
  bool wire = true;          ///< lines of the file
  bool tangent = false;      ///< between a flat face and a curved one that continues it
  bool smooth = false;       ///< all other edges of the mesh

  bool operator==(const EdgeKinds&) const = default;
};

/// The part of a symmetric view that is drawn: a half, or a quarter.
enum class HalfView { left, right, top, bottom, top_left, top_right, bottom_left, bottom_right };

/// The lines at which interrupted and partial views end: continuous with zigzags, or freehand (ISO 128-2).
enum class BreakLine { zigzag, freehand };

enum class Orientation { landscape, portrait };

/// Arrangement of the views: ISO 5456-2 (first angle) or ASME Y14.3 (third angle).
enum class ProjectionAngle { first, third };

/// How the principal views of a sheet stand: as ISO 5456-2 says, or as plan and elevation of an épura about one ground
/// line.
enum class SheetLayout { standard, monge };

/// What a sheet has room for: the views, or also the points of their constructions.
enum class SheetFit { model, construction };

/// Frame of a sheet: `plain` frames the drawing area, `full` adds centring marks, grid references, trimming marks and
/// the title block (ISO 5457, ISO 7200). `automatic`: full for several views, or if a title block field other than the
/// title is given; otherwise none.
enum class FrameKind { automatic, none, plain, full };

/// Sign between the whole and the fraction of the numbers on a sheet: "." or ",".
enum class DecimalSign { point, comma };

/// `automatic` stands for overall dimensions and those of all recognised features: holes, shafts, slots, steps,
/// fillets.
enum class DimensionType { linear, aligned, angular, radius, diameter, arc, overall, automatic };

/// How several lengths from one place are arranged (ISO 129-1): on lines of their own, one above another, from the
/// first place; in one row, each from the place before; or on one line with arrows from a common origin.
enum class DimensionArrangement { baseline, chain, ordinate };

/// How automatic dimensions give holes: a note for equal ones and dimensions of their positions, or a label at each and
/// a table of positions and sizes.
enum class HoleDimensions { notes, table };

/// Linear dimensions: direction on paper. Overall dimensions: width, height and depth along x, z and y of the world.
enum class DimensionDirection { horizontal, vertical, width, height, depth };

/// How a leader ends: at the thing that it means. ISO 128-2.
enum class LeaderEnd { automatic, arrow, dot, none };

/// A corner of the drawing area of a sheet.
enum class SheetCorner { top_left, top_right, bottom_left, bottom_right };

/// What a geometrical tolerance is about. ISO 1101.
enum class Characteristic {
  straightness,
  flatness,
  roundness,
  cylindricity,
  line_profile,
  surface_profile,
  parallelism,
  perpendicularity,
  angularity,
  position,
  concentricity,
  symmetry,
  circular_run_out,
  total_run_out
};

/// Whether material is removed to make a surface. ISO 21920-1.
enum class MaterialRemoval { any, required, prohibited };

/// Kind of edge that a line shows, in order of priority for coincident lines. `section` is the outline of a cut face,
/// `thread` the root of a screw thread, `thread_end` the end of its useful length (ISO 6410-1).
enum class EdgeKind : unsigned char {
  contour,
  boundary,
  crease,
  intersection,
  section,
  thread_end,
  wire,
  thread,
  tangent,
  smooth
};

/// Lettering in SVG: outlines look the same everywhere; text is searchable, but needs the font installed.
enum class SvgText { outlines, text };

}  // namespace epura
