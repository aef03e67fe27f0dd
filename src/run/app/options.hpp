// SPDX-License-Identifier: Apache-2.0
// The options of the command line as plain values. The tables in draw_options.cpp and command_options.cpp define names
// and permitted values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/process.hpp"
#include "output/vector_options.hpp"
#include "projection/plugin_process.hpp"
#include "scene/description.hpp"
#include "scene/details.hpp"
#include "views/options.hpp"

namespace epura {

enum class ShowProgress { automatic, always, never };
template <>
struct scene::Words<ShowProgress> {
  static constexpr std::array list{"auto", "always", "never"};
};

enum class MatrixNotation { text, latex, json };
template <>
struct scene::Words<MatrixNotation> {
  static constexpr std::array list{"text", "latex", "json"};
};

enum class AutomaticDimensions { overall, automatic, hole_table };
template <>
struct scene::Words<AutomaticDimensions> {
  static constexpr std::array list{"overall", "auto", "hole-table"};
};

struct DrawOptions {
  std::vector<std::string> models;   ///< models, or one scene file
  std::vector<std::string> outputs;  ///< "-": standard output
  std::string format;                ///< format of "-"
  std::vector<scene::Located<scene::ProjectionRequest>> projections, views;
  std::vector<scene::Located<Mat4>> transforms;
  // These override the scene file.
  scene::ModelDescription model;
  scene::ViewDescription view;
  scene::SheetDescription sheet;
  scene::Located<scene::SectionDescription> section;
  std::vector<scene::Located<scene::DetailRequest>> details;
  scene::Located<double> explode;
  scene::Located<AutomaticDimensions> dimensions;
  scene::Located<DimensionArrangement> arrangement{};
  scene::Located<scene::Anchor> datum{};                  ///< of automatic dimensions
  std::vector<scene::DimensionDescription> tolerances{};  ///< of automatic dimensions, with `match`
  bool parts_list = false;
  scene::LocatedText revise{};  ///< an older version of the model, whose differences are marked
  output::VectorOptions vector;
  pipeline::RunOptions run;
  bool timings = false;
  ShowProgress progress = ShowProgress::automatic;
  std::string found_json;    ///< lint, define: file of what they find; empty: none
  std::string lint_picture;  ///< lint: file of the drawing with its free faces hatched; empty: none
  bool lint_all = false;     ///< lint: print those that differ in numbers alone, too
  bool measure = false;      ///< measure the time saved by shortcuts, by runs without them
  /// The options that decide what is drawn and found, in words as on the command line: name and value.
  std::vector<std::pair<std::string, std::string>> given{};
};

struct PluginsOptions {
  std::string name;           ///< a projection with its parameters; empty: list all
  std::string model;          ///< file whose projection is shown step by step; empty: none
  std::optional<int> vertex;  ///< of the model, followed through all steps
  MatrixNotation notation = MatrixNotation::text;
  std::vector<std::filesystem::path> plugin_path;
};

/// A projection seen from outside.
struct PictureOptions {
  DrawOptions draw;                                       ///< without views; its model is the one that is shown
  scene::Located<scene::ProjectionRequest> projection{};  ///< that is shown
  scene::Located<scene::ProjectionRequest> from{};        ///< that shows it; by default a view from the side
  scene::Located<std::vector<int>> vertices{};            ///< through which rays run; by default chosen
  bool keeps_plane = false;                               ///< where it is, even inside the model
};

struct CheckPluginOptions {
  std::filesystem::path file;
  double time_limit = projection::plugin_seconds;
  std::string picture;  ///< file of a picture of each projection; empty: none
  std::string model;    ///< that it shows; empty: a house
};

struct ImportersOptions {
  std::string name;  ///< empty: list all
  std::vector<std::filesystem::path> plugin_path;
};

struct CheckImporterOptions {
  std::filesystem::path file;
  std::vector<std::filesystem::path> models;  ///< files that the importers should read
  double time_limit = importer::loading_seconds;
};

struct NewProjectionOptions {
  std::string name;
};

struct NewSceneOptions {
  std::string model;
  std::string output;  ///< empty: beside the model
  std::vector<std::filesystem::path> plugin_path;
};

struct RequirementsOptions {
  std::vector<std::string> models;
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> drawings;   ///< JSON of sheets that show them
  std::string json, csv, as9102, qif;  ///< files to write; empty: none
};

struct InfoOptions {
  std::vector<std::string> models;
  std::vector<std::filesystem::path> plugin_path;
  std::string json;               ///< file to write; empty: none
  std::optional<double> density;  ///< kg/m³, of all bodies
};

}  // namespace epura
