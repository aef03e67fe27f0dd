// SPDX-License-Identifier: Apache-2.0
// Description of a drawing as given by the user: by options on the command line, in a scene file (docs/formats.md), or
// by a program. Values are typed; references are resolved by the stage that knows their targets.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/colour.hpp"
#include "base/vec.hpp"
#include "mesh/soup.hpp"
#include "scene/choices.hpp"

namespace epura::scene {

/// A value, and where it was given: an option such as "--scale", or "scene.toml:12:9".
template <class Value>
struct Located {
  std::optional<Value> value{};
  std::string where{};

  [[nodiscard]] bool given() const { return value.has_value(); }
  /// The value, or `usual` where none is given.
  [[nodiscard]] Value value_or(const Value& usual) const { return value.value_or(usual); }
  const Value& operator*() const { return *value; }
  const Value* operator->() const { return &*value; }
};

using LocatedText = Located<std::string>;

struct ModelDescription {
  LocatedText file;                                           ///< in a scene file relative to its folder
  std::vector<std::pair<std::string, std::string>> import{};  ///< parameters of the file's importer and their values
  std::shared_ptr<const mesh::Soup> soup{};                   ///< instead of a file
  LocatedText name;             ///< by which dimensions call it; the file's name without extension by default
  Located<Unit> unit;           ///< the file's by default, or mm
  Located<UpAxis> up;           ///< the file's by default, or z
  Located<Mat4> transform;      ///< steps as in scene/transform.hpp
  Located<LineRole> line;       ///< of its visible lines
  Located<HiddenLines> hidden;  ///< the view's by default
  Located<Surfaces> surfaces;   ///< automatic by default
  Located<bool> drawn;          ///< true by default
};

/// How bodies with certain names are drawn, whatever their models and views say. Of several styles that match a body,
/// the last one that has a value counts.
struct StyleDescription {
  LocatedText match;  ///< names of bodies or models: * stands for any text, ? for one character, [ab] for a or b
  Located<LineRole> line;
  Located<HiddenLines> hidden;
  Located<Colour> colour;
  Located<bool> cut;    ///< by sections; true by default
  Located<bool> drawn;  ///< true by default
};

/// A view of the models. Views without a place are arranged: ISO 5456-2.
struct ViewDescription {
  LocatedText name;  ///< of its layers; the projection's by default
  Located<ProjectionRequest> projection;
  Located<ScaleChoice> scale;  ///< the sheet's by default
  Located<HiddenLines> hidden;
  Located<EdgeKinds> edges;
  LocatedText section;           ///< name of the section that it shows
  LocatedText label;             ///< written above it; "A-A" for a section by default
  Located<double> crease_angle;  ///< degrees
  Located<double> join_within;   ///< mm of paper
  Located<LayersBy> layers;
  Located<double> near, far;  ///< depths, in units of the world
  Located<Vec2> at;           ///< middle of its ink, mm from the lower left corner of the sheet
  Located<int> sheet;         ///< which one of several, from 1; the first by default
};

/// A plane that cuts the models. The side that the normal points to is removed.
struct SectionDescription {
  LocatedText name;  ///< "A"
  Vec3 point{0.0};
  Vec3 normal{0.0, -1.0, 0.0};
};

/// Vertex `second` of model `first`, both counted from 0 as in the drawing JSON; or a point of the world.
using Anchor = std::variant<std::array<int, 2>, Vec3>;

/// A dimension in a view: it follows the model. ISO 129-1.
struct DimensionDescription {
  std::string where;  ///< for errors
  LocatedText view;   ///< name of the view; the first one by default
  Located<DimensionType> type;
  Located<DimensionDirection> direction;  ///< linear: horizontal or vertical; overall: width, height or depth
  std::vector<Anchor> anchors;  ///< two ends; angular: the corner, then the ends of its legs; radius, diameter: a
                                ///< vertex on the circle; overall: none
  Located<double> offset;       ///< of the dimension line from the anchors, mm of paper; its sign gives the side
  LocatedText text;             ///< instead of the measured value; "<>" stands for the value
};

/// The fields of a title block by name ("title", "owner", "number", "date" ...). ISO 7200.
using TitleBlockFields = std::vector<std::pair<std::string, LocatedText>>;

struct SheetDescription {
  std::string where;  ///< for errors; a [[sheet]] of a scene file
  Located<PaperChoice> size;
  Located<Orientation> orientation;
  Located<ScaleChoice> scale;
  Located<ProjectionAngle> angle;
  Located<FrameKind> frame;
  Located<int> decimals;  ///< of dimensions, at most; by the size of the models by default
  TitleBlockFields title_block;
};

struct SceneDescription {
  std::vector<ModelDescription> models;
  std::vector<ViewDescription> views;
  std::vector<StyleDescription> styles;
  std::vector<SectionDescription> sections;
  std::vector<DimensionDescription> dimensions;
  std::vector<SheetDescription> sheets;  ///< the first one where a file has none
};

}  // namespace epura::scene
