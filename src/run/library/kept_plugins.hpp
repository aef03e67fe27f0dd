// SPDX-License-Identifier: Apache-2.0
// Projections whose processes stay between drawings.
#pragma once

#include <epura/epura.hpp>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "projection/catalogue.hpp"
#include "scene/description.hpp"

namespace epura {

class __attribute__((visibility("hidden"))) Plugins::Content {
 public:
  /// Adds the projections of the views of a scene to those of the calling program. Those that are not found are left to
  /// the drawing, which says so.
  void append_to(std::vector<projection::ProjectionEntry>& own, const scene::SceneDescription& scene,
                 const std::vector<std::filesystem::path>& plugin_path);

 private:
  using Key = std::pair<std::vector<std::filesystem::path>, std::string>;  ///< folders, and the name asked for

  std::mutex mutex_;
  std::map<Key, projection::ProjectionEntry> found_;
};

}  // namespace epura
