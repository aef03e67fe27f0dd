// SPDX-License-Identifier: Apache-2.0
// Finds projection plugins, asks them for their tables, and turns a request into a Projection.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.hpp"
#include "foreign/folders.hpp"
#include "foreign/parameters.hpp"
#include "projection/projection.hpp"
#include "scene/choices.hpp"

namespace epura::projection {

using foreign::BadPlugin;
using foreign::Parameter;
using foreign::ParameterType;
using foreign::ParameterValues;

struct PluginAnswer;

/// Asks a projection of a plugin: with the components of all values in the order of its table, for the box of
/// everything. Throws Error{plugin} without a place when that ends badly.
using AskProjection = std::function<PluginAnswer(const std::vector<double>& values, const Box& scene)>;

/// A projection that a plugin offers.
struct ProjectionEntry {
  std::string name;
  std::string family;
  std::string summary;
  std::string reference;
  std::vector<Parameter> parameters;
  std::filesystem::path plugin;  ///< the library it comes from
  AskProjection ask;
};

struct Catalogue {
  std::vector<ProjectionEntry> entries;  ///< sorted by family and name, one for each name
  std::vector<BadPlugin> bad;            ///< libraries and folders
};

/// Where plugins are looked for, first wins: `extra`, then $EPURA_PLUGIN_PATH (folders with colons between), then
/// next to the program (../lib/epura/projections from the executable). Never the current folder unless it is named.
std::vector<std::filesystem::path> plugin_folders(const std::vector<std::filesystem::path>& extra);

/// Reads every plugin (*.so) in the folders, each in a separate process (projection/plugin_process.hpp). Of several
/// projections with one name, the one in NAME.so is taken, otherwise the first; two in one folder are reported.
Catalogue load_catalogue(const std::vector<std::filesystem::path>& folders);

/// Finds one projection, reading as few plugins as possible: NAME.so first, then the others until it is found. "iso" is
/// isometric, and "perspective" two-point, where no NAME.so is called so.
/// Throws Error{plugin} when there is none: what is wrong with NAME.so; otherwise "did you mean", and the bad plugins
/// that might have held it.
ProjectionEntry find_projection(std::string_view name, const std::vector<std::filesystem::path>& folders);

/// Checks the values against the table, calls the plugin and checks its answer. `scene` is the box of everything.
/// Throws Error{input} for wrong values, and for values to which the answer is not a projection; Error{plugin} if
/// already the defaults have no answer.
Projection make_projection(const ProjectionEntry& entry, const scene::ProjectionRequest& request, const Box& scene);

}  // namespace epura::projection
