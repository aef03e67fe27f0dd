// SPDX-License-Identifier: Apache-2.0
// What is to be drawn, as plain values. World coordinates are right-handed, z points up; lengths are millimetres once
// the unit of a model is applied. docs/formats.md describes the same in scene files.
#pragma once

#include <array>
#include <epura/choices.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace epura {

/// A surface in memory. Points that several faces share are given once; faces have three or more corners, which are
/// indices of points, counterclockwise as seen from outside.
struct Polygons {
  std::vector<std::array<double, 3>> points{};
  std::vector<std::vector<int>> faces{};
  bool single_precision = false;  ///< points were rounded to 32 bits: what is nearer than that touches
};

struct Model {
  std::string file{};   ///< obj, stl, ply, off, or of a format for which an importer is installed; with `:key=value`
                        ///< for its parameters
  Polygons polygons{};  ///< instead of a file
  std::string name{};   ///< by which dimensions call it; by default the file's name without its extension
  std::optional<Unit> unit{};  ///< what the file says, or mm
  std::optional<UpAxis> up{};  ///< what the file says, or z
  /// Where it stands, after unit and axis: the rows of an affine matrix, which is applied to column vectors.
  std::array<double, 12> transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  LineRole line = LineRole::visible;
  Surfaces surfaces = Surfaces::automatic;
  std::optional<HiddenLines> hidden{};  ///< the view's by default
};

/// A number, several numbers, or a word.
using ParameterValue = std::variant<double, std::vector<double>, std::string>;

/// One view of the models, by a projection plugin.
struct View {
  std::string projection = "isometric";
  std::vector<std::pair<std::string, ParameterValue>> parameters{};  ///< of the projection; `epura plugins NAME`
  std::string name{};                                                ///< by default the projection's
  HiddenLines hidden = HiddenLines::dashed;
  EdgeKinds edges{};
  /// Degrees between faces from which their edge is a crease, 0 to 180; by default 5 between faces of the part that are
  /// recognised, and 30 in other meshes.
  std::optional<double> crease_angle{};
  double join_within = 0.1;                   ///< mm of paper; lines so near along each other are one, 0: all are drawn
  std::optional<double> near{}, far{};        ///< depths, to leave out what is nearer or farther
  std::optional<double> scale{};              ///< mm of paper per unit; the sheet's by default
  std::optional<std::array<double, 2>> at{};  ///< middle of its ink, mm from the lower left corner; else arranged
  int sheet = 1;                              ///< which one of several, from 1
  std::string section{};                      ///< name of the section that it shows
  std::string label{};                        ///< written above it; "A-A" for section A by default
};

/// A plane that cuts the models. What lies on the side to which the normal points is taken away.
struct Section {
  std::string name{};
  std::array<double, 3> point{0, 0, 0};
  std::array<double, 3> normal{0, -1, 0};
};

/// A vertex of a model, both counted from 0; or a point of the world.
using DimensionAnchor = std::variant<std::array<int, 2>, std::array<double, 3>>;

/// A dimension in a view: it follows the model. ISO 129-1.
struct Dimension {
  DimensionType type = DimensionType::overall;
  std::optional<DimensionDirection> direction{};  ///< linear: horizontal or vertical; overall: one of three, or all
  std::vector<DimensionAnchor> anchors{};         ///< linear, aligned: both ends; angular: the corner, then the ends of
                                                  ///< its legs; radius, diameter: a vertex on the circle
  std::string view{};                             ///< name of the view; the first one by default
  std::optional<double> offset{};                 ///< of the dimension line, mm of paper; its sign gives the side
  std::string text{};                             ///< instead of the value, for which "<>" stands
};

/// As large as fits, or the largest standard scale that fits (ISO 5455); or millimetres of paper per unit.
enum class AutomaticScale { fit, standard };
using Scale = std::variant<AutomaticScale, double>;

/// Paper of ISO 216, "A4" to "A0"; cut to the drawing; the smallest of them that takes a scale that is given; or width
/// and height in mm.
enum class AutomaticSize { cut, smallest };
using PaperSize = std::variant<std::string, AutomaticSize, std::array<double, 2>>;

struct SheetOptions {
  std::optional<PaperSize> size{};  ///< by default A4, or A3 for several views
  Orientation orientation = Orientation::landscape;
  std::optional<Scale> scale{};  ///< by default fit, or standard where there is a full frame
  ProjectionAngle angle = ProjectionAngle::first;
  FrameKind frame = FrameKind::automatic;
  /// Fields of the title block by the names of docs/formats.md ("title", "owner", "number", "date" ...) or any other.
  std::vector<std::pair<std::string, std::string>> title_block{};
};

struct Scene {
  std::vector<Model> models{};
  std::vector<View> views{};  ///< none: one isometric view
  std::vector<Section> sections{};
  std::vector<Dimension> dimensions{};
  std::vector<SheetOptions> sheets{};  ///< none: one of them
};

}  // namespace epura
