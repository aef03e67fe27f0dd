// SPDX-License-Identifier: Apache-2.0
// The description of a drawing as given by the user: by options on the command line, in a scene file (docs/scenes.md),
// or by a program. Values are typed; references are resolved by the stage that has their targets.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "mesh/soup.hpp"
#include "scene/choices.hpp"
#include "scene/construction_choice.hpp"
#include "scene/geometric_tolerances.hpp"
#include "scene/located.hpp"
#include "scene/style.hpp"
#include "scene/surface_texture.hpp"

namespace epura::scene {

/// A feature of a model by the name that `epura info` gives it, "hole 3", instead of a point. Its point is that of the
/// feature once the models are read.
struct FeatureName {
  std::string text{};                         ///< empty: none
  std::variant<int, std::string> model = -1;  ///< its number or name; -1: the only one
};

struct ModelDescription {
  LocatedText file;                                           ///< in a scene file, relative to its folder
  std::vector<std::pair<std::string, std::string>> import{};  ///< parameters of the file's importer and their values
  std::shared_ptr<const std::string> content{};               ///< of the file, which is then not read
  std::shared_ptr<const mesh::Soup> soup{};                   ///< instead of a file
  LocatedText name;             ///< name in dimensions; by default the file's name without extension
  Located<Unit> unit;           ///< by default that of the file, or mm
  Located<UpAxis> up;           ///< by default that of the file, or z
  Located<Mat4> transform;      ///< see scene/transform.hpp
  Located<LineRole> line;       ///< role of its visible lines
  Located<HiddenLines> hidden;  ///< by default as in the view
  Located<Surfaces> surfaces;   ///< by default automatic
  Located<Pmi> pmi{};           ///< by default all if the scene has dimensions or symbols, otherwise none
  Located<bool> drawn;          ///< by default true
  Located<double> density{};    ///< kg/m³, of bodies whose style has none
};

/// A view of the models. A detail view shows its parent at a larger scale, see complete_details. Views without a
/// position are arranged automatically: ISO 5456-2.
struct ViewDescription {
  LocatedText name;  ///< name of its layers; by default that of the projection
  Located<ProjectionRequest> projection;
  Located<ScaleChoice> scale;  ///< by default that of the sheet
  Located<HiddenLines> hidden;
  Located<HatchPattern> hatch;  ///< of bodies without a pattern of their own; none: of all bodies
  Located<EdgeKinds> edges;
  LocatedText section;                ///< name of the section shown
  LocatedText detail;                 ///< name of the detail shown
  Located<BreakChoice> breaks;        ///< parts that are left out
  Located<BreakLine> break_line;      ///< zigzag by default
  Located<HalfView> half;             ///< the part drawn of a symmetric view
  Located<Vec3> from;                 ///< instead of a projection: from the models towards the viewer
  LocatedText of;                     ///< name of the view beside which it is, with an arrow and a letter
  LocatedText label;                  ///< text above it; by default "A-A" for section A
  Located<double> crease_angle;       ///< degrees
  Located<double> weak_crease_angle;  ///< degrees
  Located<double> least_crease;       ///< mm on paper
  Located<double> join_within;        ///< mm on paper
  Located<LayersBy> layers;
  Located<double> near, far;                 ///< depths, in units of the world
  Located<ConstructionChoice> construction;  ///< not of details
  Located<Vec2> at;                          ///< centre of its ink, mm from the lower left corner of the sheet
  Located<int> sheet;                        ///< number of its sheet, from 1; by default the first
  Located<bool> centre_of_gravity{};         ///< whether its symbol is drawn; false by default
  Located<bool> centre_lines{};              ///< by default as for the run
  bool is_automatic = false;                 ///< its sheet gets more views, as this one, where that lacks any
};

/// A plane that cuts the models; or parallel planes with steps between them; or planes that meet in axes, which are
/// turned into one. The side to which the normal points is removed.
struct SectionDescription {
  LocatedText name;  ///< "A"
  Vec3 point{0.0};
  Vec3 normal{0.0, -1.0, 0.0};
  Located<std::vector<Vec3>> path{};  ///< corners of the cutting-plane line, instead of a point
  Located<bool> aligned{};            ///< true: the planes of the path are turned into one; false by default
  Located<bool> beyond{};             ///< true by default; false: only cut faces, without what is behind them
  Located<FeatureName> at{};          ///< instead of the point
};

/// A revolved section: the cut face at a point, turned into the picture and drawn on a view, in its place. ISO 128-3.
struct RevolvedDescription {
  LocatedText view{};         ///< name of the view; by default the first view that shows no detail
  Located<Vec3> point{};      ///< of the world, inside the cut face
  Located<Vec3> normal{};     ///< of the cutting plane, which the view sees edge-on
  Located<FeatureName> at{};  ///< instead of the point
};

/// A broken-out section: inside a closed line of a view, the models are cut by a plane parallel to the picture.
/// ISO 128-3.
struct BrokenOutDescription {
  LocatedText view{};                    ///< name of the view; by default the first view that shows no detail
  Located<Vec3> point{};                 ///< of the world, on the plane
  Located<double> radius{};              ///< of a closed line around the point, in the unit of the world
  Located<std::vector<Vec3>> outline{};  ///< instead: points of the world through which the line runs in the view
  Located<FeatureName> at{};             ///< instead of the point
};

/// A part of a view, to be shown by another view at a larger scale: a circle or an upright rectangle in its plane.
/// ISO 128-3.
struct DetailDescription {
  LocatedText name;    ///< "X"
  LocatedText view{};  ///< name of its parent; by default the first view that shows no detail
  Located<Vec3> centre{};
  Located<double> radius{};   ///< of a circle, in the unit of the world
  Located<Vec2> size{};       ///< width and height of a rectangle, likewise
  Located<FeatureName> at{};  ///< instead of the centre
};

/// Bodies moved apart in exploded views: by a vector, or outwards by a factor of their distance.
struct ExplodeDescription {
  std::string where{};   ///< for errors
  LocatedText match{};   ///< names of bodies or models, as of a style; by default all
  Located<Vec3> move{};  ///< in the unit of the world
  Located<double> factor{};
  LocatedText view{};     ///< name of the view; by default all views
  Located<bool> trace{};  ///< a line from its place to the moved body; by default if it moves along its axis
};

/// Vertex `second` of model `first`, both counted from 0 as in the drawing JSON; or a point of the world; or a feature,
/// in whose place its point stands once the models are read.
using Anchor = std::variant<std::array<int, 2>, Vec3, FeatureName>;

/// A circle of a recognised feature, or an arc of it. Units of the world.
struct FeatureCircle {
  Vec3 centre, axis;  ///< the axis has length 1
  double radius;
  std::vector<Vec3> arc{};  ///< points in order along an arc, two or more; empty for a whole circle
};

/// A number that a model file states, with its decimals: millimetres, inches or degrees.
struct StatedValue {
  double value;
  int decimals;
};

/// A dimension in a view, attached to the model. ISO 129-1.
struct DimensionDescription {
  std::string where;  ///< for errors
  LocatedText view;   ///< name of the view; by default the first one
  Located<DimensionType> type;
  Located<DimensionDirection> direction;  ///< linear: horizontal or vertical; overall: width, height or depth
  std::vector<Anchor> anchors;   ///< two ends; in an arrangement, the origin and further places; angular: the vertex,
                                 ///< then the ends of the legs; radius, diameter, arc: a vertex on the circle; overall,
                                 ///< auto: none
  std::vector<Vec3> opposite{};  ///< linear: the places if the dimension line is above or on the left; may be empty
  bool is_label = false;         ///< of a hole in a table: the text stands beside the circle; not in scene files
  std::optional<FeatureCircle> circle{};  ///< of radius and diameter, instead of an anchor; not in scene files
  Located<double> offset;           ///< of the dimension line from the anchors, mm on paper; its sign selects the side
  LocatedText text;                 ///< instead of the measured value; "<>" stands for the value
  LocatedText tolerance{};          ///< "±0.1", "+0.2 -0.1", "H7", "g6", "H7/g6"
  Located<HoleDimensions> holes{};  ///< auto: notes by default
  Located<DimensionArrangement> arrangement{};  ///< auto, and linear with several places; baseline by default
  LocatedText name{};                           ///< to which datums and tolerance frames refer
  Located<bool> limits{};                       ///< whether limits of size are written; false by default
  LocatedText match{};                          ///< texts of automatic sizes, which get what else it says: fnmatch
  std::optional<StatedValue> stated{};          ///< instead of the measured value; not in scene files
  bool is_exact = false;                        ///< theoretically, which a frame says; not in scene files
  std::string requirement{};                    ///< of a model file, by its id, that this draws; not in scene files
  std::string of_file{};  ///< auto: the option whose anchor is in the coordinates of the first model's file
};

template <>
struct Words<LeaderEnd> {
  static constexpr std::array list{"auto", "arrow", "dot", "none"};
};

/// Where a leader ends: on the models, or on the sheet, mm from its lower left corner.
using LeaderTarget = std::variant<Anchor, Vec2>;

/// Lines of text.
struct NoteText {
  std::vector<std::string> lines;
  bool has_values = false;  ///< with the signs and numbers of dimensions; not in scene files
};

/// A target of a datum: the area of a face on which the part rests there. ISO 5459. Not in scene files.
struct DatumTarget {
  std::string label;   ///< "A1"
  std::string size{};  ///< of its area: "⌀10", "20×10"; empty if there is none, or if dimensions say it
  bool is_round = false;
  Vec3 middle{0}, half_length{0}, half_width{0};  ///< of its area, in the world
};

/// What stands beside a view, with a leader into it, or alone on the sheet.
struct CalloutDescription {
  std::string where;                   ///< for errors
  LocatedText view{};                  ///< name of the view with the leader; by default the first one
  Located<LeaderTarget> to{};          ///< no leader if not given
  std::optional<FeatureCircle> rim{};  ///< that was found for the target: any point of it will do
  LocatedText dimension{};             ///< instead: name of a dimension, in line with which it stands
  Located<LeaderEnd> end{};            ///< by default an arrow on a line, otherwise a dot
  Located<Vec2> at{};         ///< upper left corner, mm from the lower left corner of the sheet; by default chosen
  Located<int> sheet{};       ///< without a leader: number of its sheet, from 1; by default the first
  std::string requirement{};  ///< of a model file, by its id, that this draws; not in scene files
  std::variant<NoteText, ToleranceFrame, DatumFeature, DatumTarget, SurfaceTexture> content{};
};

/// A screw thread in a hole or on a shaft, drawn as in ISO 6410-1.
struct ThreadDescription {
  std::string where{};      ///< for errors
  LocatedText thread{};     ///< "M6", "M6x0.75", "M6-6H"
  Located<Anchor> at{};     ///< on the hole or shaft, its rim or its axis; nearest to the end where the thread begins
  Located<double> depth{};  ///< useful length, mm; by default all of the cylinder
  Located<bool> equal{};    ///< whether all equal holes or shafts of the model have it; false by default
  Located<bool> callout{};  ///< whether it has a dimension of its own; true by default
  LocatedText view{};       ///< name of the view with that; by default the one that shows it best
};

/// What is required of faces of a model, as model files state it.
struct RequirementDescription {
  std::string where{};             ///< for errors
  LocatedText name{};              ///< its id in the ledger; by default "requirement 3", by its place in the scene
  LocatedText type{};              ///< "diameter", "linear distance", "flatness", "datum"
  Located<FeatureName> feature{};  ///< that it is about
  Located<FeatureName> to{};       ///< the other end of a length or angle
  LocatedText value{};             ///< of a dimension, with its decimals: "8.00"; by default that of the model
  LocatedText tolerance{};         ///< of a dimension: "±0.1", "+0.2 -0.1", "H7"
  ToleranceFrame frame{};          ///< zone and datums of a geometrical tolerance
  LocatedText letter{};            ///< of a datum
};

/// A feature of which `epura lint` need not say what is not dimensioned.
struct AcceptedDescription {
  Located<FeatureName> feature{};
  LocatedText reason{};
};

template <>
struct Words<SheetCorner> {
  static constexpr std::array list{"top-left", "top-right", "bottom-left", "bottom-right"};
};

/// A table of texts on a sheet.
struct TableDescription {
  std::string where{};  ///< for errors
  LocatedText title{};  ///< above the others
  std::vector<std::string> header{};
  std::vector<std::vector<std::string>> rows{};  ///< each has as many cells as the header, or as the first row
  Located<SheetCorner> corner{};                 ///< the free room nearest to it; by default the top right corner
  Located<Vec2> at{};                            ///< its upper left corner instead, mm
  Located<int> sheet{};                          ///< number of its sheet, from 1; by default the first
};

/// A row of the table of revisions of a sheet.
struct RevisionDescription {
  LocatedText revision{};  ///< "B"
  LocatedText date{}, text{}, author{};
  Located<int> sheet{};  ///< number of its sheet, from 1; by default the first
};

/// Fields of a title block by name ("title", "owner", "number", "date" ...). ISO 7200.
using TitleBlockFields = std::vector<std::pair<std::string, LocatedText>>;

struct SheetDescription {
  std::string where;  ///< location for errors; a [[sheet]] of a scene file
  Located<PaperChoice> size;
  Located<Orientation> orientation;
  Located<ScaleChoice> scale;
  Located<ProjectionAngle> angle;
  Located<SheetLayout> layout;
  Located<SheetFit> fit;
  Located<FrameKind> frame;
  Located<int> decimals;              ///< of dimensions, at most; by the size of the models by default
  Located<Unit> dimension_unit;       ///< of the lengths in dimensions
  Located<DecimalSign> decimal_sign;  ///< of the numbers on the sheet
  LocatedText font;                   ///< file or family of the lettering; by default osifont
  LocatedText form;                   ///< SVG file with a frame and title block, instead of those of the standards
  LocatedText logo;                   ///< SVG or PNG file, in the title block
  LocatedText style;                  ///< file with colours, widths and dashes of lines
  TitleBlockFields title_block;

  /// A field of the title block; empty if it is not given.
  [[nodiscard]] std::string field(std::string_view name) const {
    for (const auto& [known, text] : title_block)
      if (known == name) return *text;
    return {};
  }
};

/// A list of the parts with numbers, and balloons in the views that refer to them. ISO 7573, ISO 6433.
struct PartsListDescription {
  std::string where;         ///< for errors
  LocatedText view{};        ///< name of the view with the balloons; by default that in which each item is seen best
  Located<int> sheet{};      ///< number of its sheet, from 1; by default the first
  Located<bool> balloons{};  ///< true by default
};

struct SceneDescription {
  std::vector<ModelDescription> models;
  std::vector<ViewDescription> views;
  std::vector<StyleDescription> styles;
  std::vector<SectionDescription> sections;
  std::vector<DetailDescription> details;
  std::vector<BrokenOutDescription> broken_outs;
  std::vector<RevolvedDescription> revolved{};
  std::vector<ExplodeDescription> explosions;
  std::vector<DimensionDescription> dimensions;
  std::vector<ThreadDescription> threads{};
  std::vector<CalloutDescription> callouts{};  ///< in the order of the scene
  std::vector<RequirementDescription> requirements{};
  std::vector<AcceptedDescription> accepted{};
  std::vector<TableDescription> tables{};
  std::vector<RevisionDescription> revisions{};
  std::vector<SheetDescription> sheets;  ///< one default sheet if a scene file has none
  std::optional<PartsListDescription> parts_list{};
};

}  // namespace epura::scene
