// SPDX-License-Identifier: Apache-2.0
#include "library/kept_plugins.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace epura {

Plugins::Plugins() : content_(std::make_shared<Content>()) {}

void Plugins::Content::append_to(std::vector<projection::ProjectionEntry>& own, const scene::SceneDescription& scene,
                                 const std::vector<std::filesystem::path>& plugin_path) {
  const auto is_there = [&](const std::string& name) {
    return std::any_of(own.begin(), own.end(), [&](const auto& entry) { return entry.name == name; });
  };
  const auto folders = projection::plugin_folders(plugin_path);
  const std::lock_guard lock(mutex_);
  for (const scene::ViewDescription& view : scene.views) {
    const std::string& name = view.projection->name;
    if (!view.projection.given() || is_there(name)) continue;
    auto known = found_.find({folders, name});
    try {
      if (known == found_.end())
        known = found_.emplace(Key{folders, name}, projection::find_projection(name, folders)).first;
    } catch (const Error&) {
      continue;
    }
    if (!is_there(known->second.name)) own.push_back(known->second);
  }
}

}  // namespace epura
