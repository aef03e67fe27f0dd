// SPDX-License-Identifier: Apache-2.0
// The options of the command line as plain values. The tables in draw_options.cpp and command_options.cpp define names
// and permitted values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "importer/process.hpp"
#include "output/vector_options.hpp"
#include "pipeline/options.hpp"
#include "projection/plugin_process.hpp"
#include "scene/description.hpp"
#include "scene/details.hpp"
#include "scene/toml_tree.hpp"

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
  bool parts_list = false;
  output::VectorOptions vector;
  pipeline::RunOptions run;
  bool timings = false;
  ShowProgress progress = ShowProgress::automatic;
  std::string lint_json;  ///< lint: file of its findings; empty: none
  bool lint_all = false;  ///< lint: print those that differ in numbers alone, too
  bool measure = false;   ///< measure the time saved by shortcuts, by runs without them
};

/// An option whose value is not read before the job is known.
struct LaterOption {
  std::string flag;  ///< as in the table of options
  scene::TomlValue value;
};

struct BatchOptions {
  DrawOptions draw;                  ///< what all jobs have in common, and in `models` the sources
  std::vector<LaterOption> later;    ///< options with placeholders
  std::vector<std::string> words;    ///< options that change drawings, as given
  std::vector<std::string> tables;   ///< files with a job in each row
  bool again = false;                ///< draw what has not changed, too
  bool resume = false;               ///< only if there is a manifest
  std::string manifest;              ///< empty: beside the outputs
  std::string merge;                 ///< manifest whose parts are joined, instead of drawing; or its folder
  std::string shard;                 ///< "2/8", or "auto" for the number that the scheduler gives
  std::string report, junit;         ///< files to write; empty: none
  int workers = 0;                   ///< number of jobs at the same time; 0: one for each core
  std::optional<double> job_time;    ///< seconds
  std::optional<double> job_memory;  ///< MB
  ShowProgress progress = ShowProgress::automatic;
};

struct ServeOptions {
  DrawOptions draw;                ///< of all drawings, but for the projection that the page chooses
  std::vector<std::string> words;  ///< the same as given, for command lines
  int port = 0;                    ///< 0: any that is free
  double job_time = 60;            ///< seconds for a view or a drawing
  double job_memory = 4000;        ///< MB for a drawing
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

struct CompareOptions {
  std::string before, after;                                    ///< drawings, models or scene files
  std::vector<scene::Located<scene::ProjectionRequest>> views;  ///< views of models
  std::vector<std::filesystem::path> plugin_path;
  bool allow_outside = false;
  double tolerance = 0.001;   ///< mm
  std::string json, overlay;  ///< files to write; empty: none
};

struct InfoOptions {
  std::vector<std::string> models;
  std::vector<std::filesystem::path> plugin_path;
  std::string json;               ///< file to write; empty: none
  std::optional<double> density;  ///< kg/m³, of all bodies
};

struct SnapshotOptions {
  std::vector<std::string> folders;  ///< folders that contain cases, or cases themselves
  bool accept = false;               ///< make the current drawings the expected ones
  double tolerance = 0.001;          ///< mm
  std::string report, junit;         ///< files to write; empty: none
  std::vector<std::filesystem::path> plugin_path;
  int threads = 0;  ///< number of cases drawn concurrently
};

}  // namespace epura
