// SPDX-License-Identifier: Apache-2.0
// `epura compare`: the visible differences between two drawings, models or scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

struct CompareOptions {
  std::string before, after;                                    ///< drawings, models or scene files
  std::vector<scene::Located<scene::ProjectionRequest>> views;  ///< views of models
  std::vector<std::filesystem::path> plugin_path;
  bool allow_outside = false;
  double tolerance = 0.001;             ///< mm
  std::string json, markdown, overlay;  ///< files to write; empty: none
};

scene::Options<CompareOptions> compare_options();

/// Returns the exit code.
int compare_files(const CompareOptions& options);

}  // namespace epura
