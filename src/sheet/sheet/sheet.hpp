// SPDX-License-Identifier: Apache-2.0
// A sheet with strokes, fills and texts: everything a writer needs, with nothing left to compute.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/colour.hpp"
#include "base/vec.hpp"
#include "drawing/curve_part.hpp"
#include "edges/edge_kind.hpp"
#include "scene/choices.hpp"
#include "scene/geometric_tolerances.hpp"

namespace epura::sheet {

/// The pattern of a line, in millimetres on paper: a dash and a gap, then `dots` times a dot and a gap. ISO 128-2. dash
/// 0: continuous.
struct Dashes {
  double dash = 0, gap = 0;
  double dot = 0;
  int dots = 0;

  bool operator==(const Dashes&) const = default;
};

/// Appearance of a layer's lines. ISO 128-2; lengths in millimetres on paper.
struct LineStyle {
  std::string name;  ///< class in SVG, such as "visible"
  double width;
  Dashes dashes{};
  Colour colour{};  ///< of the fills and texts of the layer, too
};

/// An edge of a model, by its vertex numbers in the file, the lower first.
struct ModelEdge {
  int model;
  std::array<int, 2> vertex;

  bool operator==(const ModelEdge&) const = default;
};

/// What the model tells of a stroke, for documents that answer questions.
struct LineFacts {
  double length = 0;            ///< of the stroke's edges in space, as wholes, in units of the world
  std::vector<int> faces{};     ///< numbers in the file of faces at these edges: the first ones
  int more_faces = 0;           ///< how many more there are
  int body = -1;                ///< of its model; -1 if the edge belongs to no face
  std::vector<double> depth{};  ///< along the third axis of ViewDrawing::world_to_page: one number if it is the same
                                ///< everywhere, the two of a straight line's ends, three if it is a x + b y + c, with y
                                ///< up, or one for each point; empty if unknown
};

/// One polyline, drawn without lifting the pen.
struct Stroke {
  std::vector<Vec2> points;  ///< y up, origin at the lower left corner of the sheet
  bool closed = false;
  Dashes dashes{};                 ///< fitted to this stroke, so that it ends on dashes
  std::vector<double> pattern{};   ///< instead, if crossings require it: ink, gap, ink, gap ... for the whole stroke
  std::optional<EdgeKind> kind{};  ///< of the edge drawn; nothing for a frame
  std::vector<ModelEdge> edges{};  ///< the edges drawn, in order
  std::vector<drawing::CurvePart> curves{};  ///< parts of the points that are arcs, ascending and disjoint
  int facts = -1;                            ///< index into Sheet::line_facts; -1: nothing is known
  int feature = -1;                          ///< likewise into Sheet::features
};

/// An area filled with black by the even-odd rule. Rings do not repeat their first point.
struct Fill {
  std::vector<std::vector<Vec2>> rings;
};

enum class Align { left, middle, right };

/// A line of lettering in the font of the sheet (sheet/lettering.hpp).
struct Text {
  std::string text;  ///< UTF-8
  Vec2 at;           ///< on the base line: its left end, middle or right end
  double height;     ///< of capitals, mm. ISO 3098
  double angle = 0;  ///< of the base line, degrees counterclockwise
  Align align = Align::left;
  std::string role{};  ///< class in SVG: "title", "dimension", "label" ...
};

/// A run of the strokes, fills or texts of a layer: from `begin` up to, without, `end`.
struct InkRange {
  std::size_t begin = 0, end = 0;
};

/// Parallel lines of a hatching.
struct HatchLines {
  double angle;    ///< degrees counterclockwise
  double spacing;  ///< mm
  double start;    ///< distance of one of them from the origin of the sheet, to the left of their direction, mm
  bool is_dashed = false;
};

/// A hatched face as one thing, for formats that have such things. Its ink are strokes of the layer.
struct HatchedFace {
  Fill face;
  HatchPattern pattern;
  double angle, spacing;  ///< of the pattern
  std::vector<HatchLines> lines;
  InkRange strokes;
};

enum class DimensionShape { linear, angular, diameter, radius, ordinate };

/// A dimension as one thing, likewise. Of several that are drawn together, the first has the ink of all.
struct DimensionObject {
  DimensionShape shape;
  /// linear: the measured ends, and a point of the dimension line; angular: the vertex, the ends of the legs, and a
  /// point of the arc; diameter: two opposite points, the second at the leader; radius: the centre, and a point at the
  /// leader; ordinate: the origin, the measured place, and the end of its line.
  std::vector<Vec2> points;
  double angle = 0;    ///< linear: of the dimension line, degrees counterclockwise; ordinate: of what is measured
  double oblique = 0;  ///< linear: angle of the extension lines to the dimension line if it is not 90 degrees
  double leader = 0;   ///< its length, mm
  double value = 0;    ///< that is written, without tolerances, in the unit of the sheet; 0: an angle, or none
  std::string text{};
  Vec2 text_middle{0, 0};
  double text_height = 0, arrow = 0, gap = 0, overshoot = 0, above = 0;  ///< sizes of its parts, mm
  InkRange strokes{}, fills{}, texts{};
  int number = -1;           ///< of the dimension among those of its view
  std::string id{};          ///< by what it measures, so that it stays as long as that does; empty: unknown
  std::string tolerance{};   ///< "+0.2 -0.1", "H7"
  std::vector<int> faces{};  ///< that it measures, by their numbers in scenes
  int feature = -1;          ///< index into Sheet::features; -1: none in particular
};

/// A leader as one thing, likewise, perhaps with the text on its last piece.
struct LeaderObject {
  std::vector<Vec2> points;  ///< from what it means
  LeaderEnd end;             ///< not automatic
  double arrow;              ///< its length, mm
  std::vector<std::string> lines{};
  Vec2 text_corner{0, 0};  ///< the upper left one
  double text_height = 0;
  InkRange strokes{}, fills{}, texts{};
};

/// A row of a tolerance frame: compartments after the symbol.
struct FrameRow {
  Characteristic characteristic;
  std::vector<scene::FrameCell> cells;
};

/// A tolerance frame as one thing, likewise. Without rows: ink of one that is in another layer.
struct ToleranceObject {
  std::vector<FrameRow> rows{};  ///< from above; further ones have the symbol of the first
  Vec2 at{0, 0};                 ///< the middle of the left side of the first one
  double text_height = 0;
  InkRange strokes{}, fills{}, texts{};
};

struct TableCell {
  std::string text;
  bool is_right = false;  ///< aligned
};

/// A table as one thing, likewise. A row of one cell is as wide as the table.
struct TableObject {
  Vec2 corner{0, 0};  ///< the upper left one
  std::vector<double> widths{};
  double row_height = 0, text_height = 0, margin = 0;  ///< the last one beside texts
  std::vector<std::vector<TableCell>> rows{};
  InkRange strokes{}, texts{};
};

/// A picture of pixels in an upright rectangle.
struct Picture {
  std::shared_ptr<const std::string> png;  ///< bytes of the file
  std::string name;                        ///< of the file, for messages
  Vec2 min, max;                           ///< mm
};

/// The objects of a layer come in the order of their ink.
struct Layer {
  std::string name;  ///< "isometric/visible"
  LineStyle style;
  std::vector<Stroke> strokes;
  std::vector<Fill> fills{};
  std::vector<Text> texts{};
  std::vector<HatchedFace> hatched{};
  std::vector<DimensionObject> dimensions{};
  std::vector<LeaderObject> leaders{};
  std::vector<ToleranceObject> tolerances{};
  std::vector<TableObject> tables{};
  std::vector<Picture> pictures{};  ///< below all other ink of the layer
};

/// Position of a view, for bookmarks and descriptions.
struct ViewFrame {
  std::string name;
  std::string projection;
  std::string scale;  ///< "1:2"; empty if the view has none
  Vec2 min, max;      ///< box of its ink, mm
};

/// Equal features that a view shows, for people who do not see it.
struct ShownFeature {
  std::string view;
  std::string words;  ///< "4 × hole, diameter 8, through"
};

/// What a sheet shows, for people who do not see it.
struct Summary {
  std::string language;  ///< code
  std::vector<std::string> sentences;
};

/// A lettering font. Without a file: osifont.
struct Font {
  std::filesystem::path file{};
  int face = 0;          ///< number of the font in a collection
  std::string family{};  ///< its name
};

struct Sheet {
  double width = 0, height = 0;  ///< mm
  std::string title;             ///< for the metadata of the file
  std::vector<Layer> layers;     ///< painted in order
  std::vector<ViewFrame> views{};
  std::vector<std::pair<std::string, std::string>> facts{};  ///< more metadata: ("author", "N. N."), ("scale", "1:2")
  Font font{};
  std::vector<Summary> summaries{};      ///< in its language, then in others; only if requested (RunOptions::describes)
  std::vector<ShownFeature> features{};  ///< likewise
  std::vector<LineFacts> line_facts{};   ///< only if a document answers questions (pipeline::RunOptions::line_facts)
};

}  // namespace epura::sheet
