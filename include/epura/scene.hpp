// SPDX-License-Identifier: Apache-2.0
// Description of a drawing in plain values. World coordinates are right-handed, z points up; lengths are millimetres
// after applying the unit of a model. docs/formats.md describes the corresponding scene files.
#pragma once

#include <array>
#include <epura/choices.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace epura {

/// A surface in memory. Shared points are given once; faces have three or more corners, which are indices of points,
/// counterclockwise as seen from outside.
struct Polygons {
  std::vector<std::array<double, 3>> points{};
  std::vector<std::vector<int>> faces{};
  std::vector<int> bodies{};                  ///< by face: the number of its body; empty: connected faces are a body
  std::vector<std::string> body_names{};      ///< by body, for styles and layers; needed with `bodies`
  std::vector<std::vector<int>> polylines{};  ///< lines that bound no face: two or more indices of points each
  bool single_precision = false;              ///< points were rounded to 32 bits, which widens the contact tolerance
};

struct Model {
  std::string file{};     ///< obj, stl, ply, off, or of a format for which an importer is installed; with `:key=value`
                          ///< for its parameters
  std::string content{};  ///< bytes of the file, which is then not read: `file` gives its name and format
  Polygons polygons{};    ///< instead of a file
  std::string name{};     ///< name for dimensions; by default the file name without extension
  std::optional<Unit> unit{};  ///< that of the file by default, or mm
  std::optional<UpAxis> up{};  ///< that of the file by default, or z
  /// Position, applied after unit and axis: the rows of an affine matrix for column vectors.
  std::array<double, 12> transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  LineRole line = LineRole::visible;
  Surfaces surfaces = Surfaces::automatic;
  std::optional<HiddenLines> hidden{};  ///< by default as in the view
};

/// How bodies with certain names are drawn, whatever their models and views say. Of several styles that match a body,
/// the last one that has a value counts.
struct Style {
  std::string match = "*";  ///< names of bodies or models: * stands for any text, ? for one character, [ab] for a or b
  std::optional<LineRole> line{};
  std::optional<HiddenLines> hidden{};
  std::optional<std::array<int, 3>> colour{};  ///< red, green and blue, 0 to 255; black by default
  bool file_colour = false;                    ///< the colours of the files instead, darkened if they are light
  std::optional<HatchPattern> hatch{};         ///< of their cut faces; by default the view's
  std::optional<double> hatch_angle{};         ///< degrees counterclockwise, 0 to 180; by default automatic
  std::optional<double> hatch_pitch{};         ///< mm between lines, 0.5 to 50; by default automatic
  bool cut = true;                             ///< false: sections leave them whole, as bolts, shafts and balls
  bool drawn = true;
};

/// A number, several numbers, or a word.
using ParameterValue = std::variant<double, std::vector<double>, std::string>;

/// A part of a view that is left out, between two places on an axis of the world (0: x, 1: y, 2: z); infinite: up to
/// the end of the view.
struct Break {
  int axis = 0;
  double from = 0, to = 0;
};

/// A view of the models through a projection plugin.
struct View {
  std::string projection = "isometric";
  std::vector<std::pair<std::string, ParameterValue>> parameters{};  ///< see `epura plugins NAME`
  std::string name{};                                                ///< by default the projection's
  std::optional<HiddenLines> hidden{};  ///< by default dashed; none in pictorial views and sections
  std::optional<HatchPattern> hatch{};  ///< of cut faces; none: outlines only; by default general
  EdgeKinds edges{};
  /// Smallest angle between two faces whose common edge is a crease, 0 to 180 degrees; by default 5 between recognised
  /// faces of the part, and 30 in other meshes.
  std::optional<double> crease_angle{};
  /// The same for edges of scans and other meshes without recognised faces that continue a crease; by default
  /// crease_angle.
  std::optional<double> weak_crease_angle{};
  double least_crease = 0;   ///< mm on paper; shorter creases that meet no other line are left out
  double join_within = 0.1;  ///< mm on paper; closer parallel lines are drawn as one, 0: draw all
  LayersBy layers = LayersBy::role;
  std::optional<double> near{}, far{};        ///< depths; omit what is nearer or farther
  std::vector<std::string> construction{};    ///< "horizon", "vp:1,1,0" ...: see docs/formats.md
  std::optional<double> scale{};              ///< mm on paper per unit; by default the sheet's
  std::optional<std::array<double, 2>> at{};  ///< centre of its ink, mm from the lower left corner; default: automatic
  int sheet = 1;                              ///< number of the sheet, from 1
  std::string section{};                      ///< name of the section shown
  std::vector<Break> breaks{};                ///< interrupted and partial views
  bool automatic_breaks = false;              ///< leave out long stretches of constant section
  BreakLine break_line = BreakLine::zigzag;   ///< at which interrupted and partial views end
  std::optional<HalfView> half{};             ///< the part of a symmetric view that is drawn
  std::string label{};   ///< text above the view; by default "A-A" for section A, "X" and the scale for detail X
  std::string detail{};  ///< name of the detail shown; then the view has the projection, the parameters and the section
                         ///< of the view that it enlarges, and needs a scale
};

/// A plane that cuts the models. The side to which the normal points is removed.
struct Section {
  std::string name{};
  std::array<double, 3> point{0, 0, 0};
  std::array<double, 3> normal{0, -1, 0};
  std::vector<std::array<double, 3>> path{};  ///< instead of the point: corners of the cutting-plane line, whose legs
                                              ///< are perpendicular to the normal, or steps parallel to it
  bool beyond = true;                         ///< false: only cut faces, without what is behind them (removed sections)
  bool aligned = false;                       ///< the legs of the path are planes, which are turned into one
};

/// A revolved section: the cut face around a point of a plane that the view sees edge-on, turned into the picture.
struct Revolved {
  std::string view{};  ///< name of the view on which it is drawn; by default the first one
  std::array<double, 3> point{0, 0, 0};
  std::array<double, 3> normal{0, 0, 1};
};

/// A part of a parallel view, which another view shows at a larger scale: a circle with this radius in its plane, or
/// instead a rectangle with this width and height.
struct Detail {
  std::string name{};
  std::string view{};  ///< name of the view that it enlarges; by default the first one that shows no detail
  std::array<double, 3> centre{0, 0, 0};
  std::optional<double> radius{};
  std::optional<std::array<double, 2>> size{};
};

/// Bodies moved apart in exploded views: by a vector, or away from the largest body along their axis by a multiple of
/// their distance.
struct Explode {
  std::string match{};  ///< names of bodies or models, as of a style; by default all
  std::optional<std::array<double, 3>> move{};
  std::optional<double> factor{};  ///< instead of a vector
  std::string view{};              ///< name of the view; by default all views
  std::optional<bool> trace{};     ///< a line from their places; by default if they move along their axes
};

/// A model and a vertex of it, both counted from 0; or a point of the world.
using DimensionAnchor = std::variant<std::array<int, 2>, std::array<double, 3>>;

/// A dimension in a view, attached to the model. ISO 129-1.
struct Dimension {
  DimensionType type = DimensionType::overall;
  std::optional<DimensionDirection> direction{};  ///< linear: horizontal or vertical; overall: empty for all three
  std::vector<DimensionAnchor> anchors{};         ///< linear, aligned: both ends; in an arrangement two or more places,
                                                  ///< the origin first; angular: the vertex, then the ends of the
                                                  ///< legs; radius, diameter, arc: a vertex on the circle
  std::string view{};                             ///< name of the view; by default the first one
  std::optional<double> offset{};                 ///< mm on paper to the dimension line; its sign selects the side
  std::string text{};                             ///< text instead of the value; "<>" stands for the value
  std::string tolerance{};                        ///< "±0.1", "+0.2 -0.1", "H7", "g6" or "H7/g6" (ISO 286-1)
  HoleDimensions holes = HoleDimensions::notes;   ///< of automatic dimensions
  bool limits = false;                            ///< whether limits of size are written; needs a tolerance
  std::optional<DimensionArrangement> arrangement{};  ///< linear, and positions of automatic dimensions: several
                                                      ///< lengths in one row; by default single dimensions
};

/// A screw thread in a hole or on a shaft, drawn as in ISO 6410-1.
struct Thread {
  std::string thread{};           ///< size of ISO 261: "M6", "M6x0.75", "M6-6H"
  DimensionAnchor at{};           ///< on the hole or shaft or its axis, near the end where the thread begins
  std::optional<double> depth{};  ///< useful length, mm; by default all of the cylinder
  bool equal = false;             ///< all equal and parallel holes or shafts of the model have it, too
  bool callout = true;            ///< whether it has a dimension of its own
  std::string view{};             ///< name of the view with that; by default the one that shows it best
};

/// Largest scale that fits, largest standard scale that fits (ISO 5455), or millimetres on paper per unit.
enum class AutomaticScale { fit, standard };
using Scale = std::variant<AutomaticScale, double>;

/// ISO 216 size, "A4" to "A0", or ASME Y14.1 size, "ANSI-A" to "ANSI-E"; cut to the drawing; the smallest of these
/// sizes that fits at the given scale; or width and height in mm.
enum class AutomaticSize { cut, smallest };
using PaperSize = std::variant<std::string, AutomaticSize, std::array<double, 2>>;

struct SheetOptions {
  std::optional<PaperSize> size{};  ///< by default A4, or A3 for several views
  Orientation orientation = Orientation::landscape;
  std::optional<Scale> scale{};  ///< by default fit, or standard with a full frame
  ProjectionAngle angle = ProjectionAngle::first;
  SheetLayout layout = SheetLayout::standard;
  SheetFit fit = SheetFit::model;
  FrameKind frame = FrameKind::automatic;
  Unit dimension_unit = Unit::mm;  ///< of the lengths in dimensions
  DecimalSign decimal_sign = DecimalSign::point;
  std::string font{};  ///< of the lettering: an installed family, or a .ttf or .otf file; empty: osifont
  std::string
      sheet_template{};  ///< SVG file with frame and title block, which gives the size; empty: those of the standards
  std::string logo{};    ///< SVG or PNG file for the title block; empty: none
  std::string style{};   ///< TOML file with colours, widths and dashes of lines by role; empty: ISO 128-2
  /// Title block fields by the names in docs/formats.md ("title", "owner", "number", "date" ...) or any other name.
  std::vector<std::pair<std::string, std::string>> title_block{};
};

struct Scene {
  std::vector<Model> models{};
  std::vector<Style> styles{};
  std::vector<View> views{};  ///< none: one isometric view
  std::vector<Section> sections{};
  std::vector<Revolved> revolved{};
  std::vector<Detail> details{};
  std::vector<Explode> explosions{};
  std::vector<Dimension> dimensions{};
  std::vector<Thread> threads{};
  std::vector<SheetOptions> sheets{};  ///< none: one default sheet
};

}  // namespace epura
