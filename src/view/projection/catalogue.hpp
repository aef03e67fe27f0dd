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

/// Requests a projection from a plugin, given the components of all values in the order of its table and the bounding
/// box of everything. Throws Error{plugin} without a place if that fails.
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
  std::vector<BadPlugin> bad;            ///< libraries and folders that could not be used
};

/// Returns the folders in which plugins are searched for, in order of precedence: `extra`, then $EPURA_PLUGIN_PATH
/// (folders separated by colons), then the one next to the program (../lib/epura/projections from the executable).
/// Never contains the current folder unless it is named.
std::vector<std::filesystem::path> plugin_folders(const std::vector<std::filesystem::path>& extra);

/// Reads every plugin (*.so) in the folders, each in a separate process (projection/plugin_process.hpp). Of several
/// projections with one name, the one in NAME.so is used, otherwise the first; two in one folder are reported.
Catalogue load_catalogue(const std::vector<std::filesystem::path>& folders);

/// Finds one projection, reading as few plugins as possible: NAME.so first, then the others until it is found. "iso"
/// means isometric and "perspective" two-point, unless there is a NAME.so of that name. If there is no such projection,
/// throws Error{input} with "did you mean"; Error{plugin} with the fault of NAME.so if it exists, or with the bad
/// plugins that might have contained it. `own` are projections of the calling program, which come before all plugins.
ProjectionEntry find_projection(std::string_view name, const std::vector<std::filesystem::path>& folders,
                                const std::vector<ProjectionEntry>& own = {});

/// Checks the values against the table, calls the plugin and checks its answer. `scene` is the bounding box of
/// everything. Throws Error{input} for invalid values, and for values to which the answer is not a projection;
/// Error{plugin} if even the defaults have no valid answer.
Projection make_projection(const ProjectionEntry& entry, const scene::ProjectionRequest& request, const Box& scene);

}  // namespace epura::projection
