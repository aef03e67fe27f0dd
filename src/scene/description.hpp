// SPDX-License-Identifier: Apache-2.0
// What is to be drawn, as the user said it: by options of the command line or in a scene file (docs/formats.md).
//
// Words stay words here: the stage that knows them parses them, and its errors name the place they came from.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/vec.hpp"

namespace epura {

/// A value as the user gave it, and where: an option such as "--scale", or "scene.toml:12:9". Empty text: not given.
struct Given {
  std::string text{};
  std::string where{};

  [[nodiscard]] bool given() const { return !text.empty(); }
};

struct ModelDescription {
  Given file;       ///< in a scene file relative to its folder
  Given name;       ///< by which dimensions call it; the file's name without extension by default
  Given unit;       ///< mm, in or m; mm by default
  Given up;         ///< z or y; z by default
  Given transform;  ///< steps as in scene/transform.hpp
  Given line;       ///< role of its visible lines: visible (default), narrow, or neighbour (ISO 128-2, type 05.1)
  Given hidden;     ///< none, dashed or solid; the view's by default
  bool drawn = true;
};

/// A view of the models. Views without a place are arranged: ISO 5456-2.
struct ViewDescription {
  Given name;        ///< of its layers; the projection's by default
  Given projection;  ///< NAME[:key=value...]
  Given scale;       ///< the sheet's by default
  Given hidden;      ///< none, dashed or solid
  Given edges;       ///< kinds with commas
  Given section;     ///< name of the section that it shows
  Given label;       ///< written above it; "A-A" for a section by default
  std::optional<double> crease_angle, near, far;
  std::optional<Vec2> at;  ///< middle of its ink, mm from the lower left corner of the sheet
  int sheet = 1;           ///< which one of several
};

/// A plane that cuts the models. What lies on the side to which the normal points is taken away.
struct SectionDescription {
  Given name;  ///< "A"
  Vec3 point{0.0};
  Vec3 normal{0.0, -1.0, 0.0};
};

/// Vertex `second` of model `first`, both counted from 0 as in the drawing JSON; or a point of the world.
using Anchor = std::variant<std::array<int, 2>, Vec3>;

/// A dimension in a view: it follows the model. ISO 129-1.
struct DimensionDescription {
  std::string where;             ///< for errors
  Given view;                    ///< name of the view; the first one by default
  Given type;                    ///< linear, aligned, angular, radius, diameter or overall
  Given direction;               ///< of a linear one: horizontal or vertical; overall: width, height or depth
  std::vector<Anchor> anchors;   ///< two ends; angular: the corner, then the ends of its legs; radius, diameter: a
                                 ///< vertex on the circle; overall: none
  std::optional<double> offset;  ///< of the dimension line from the anchors, mm of paper; its sign gives the side
  Given text;                    ///< instead of the measured value; "<>" stands for the value
};

/// The fields of a title block by name ("title", "owner", "number", "date" ...). ISO 7200.
using TitleBlockFields = std::vector<std::pair<std::string, Given>>;

struct SheetDescription {
  std::string where;  ///< for errors; a [[sheet]] of a scene file
  Given size;         ///< A4 ... A0, WIDTHxHEIGHT, none
  Given orientation;  ///< landscape or portrait
  Given scale;        ///< fit, auto, 1:2 ...
  Given angle;        ///< first or third
  Given frame;        ///< auto, none, plain or full
  TitleBlockFields title_block;
};

struct SceneDescription {
  std::vector<ModelDescription> models;
  std::vector<ViewDescription> views;
  std::vector<SectionDescription> sections;
  std::vector<DimensionDescription> dimensions;
  std::vector<SheetDescription> sheets;  ///< the first one where a file has none
};

}  // namespace epura
