// SPDX-License-Identifier: Apache-2.0
// `epura snapshot`: cases are drawn and compared with expected drawings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/option.hpp"

namespace epura {

struct SnapshotOptions {
  std::vector<std::string> folders;  ///< folders that contain cases, or cases themselves
  bool accept = false;               ///< make the current drawings the expected ones
  double tolerance = 0.001;          ///< mm
  std::string report, junit;         ///< files to write; empty: none
  std::vector<std::filesystem::path> plugin_path;
  int threads = 0;  ///< number of cases drawn concurrently
};

scene::Options<SnapshotOptions> snapshot_options();

/// Returns the exit code.
int snapshot(const SnapshotOptions& options);

}  // namespace epura
