// SPDX-License-Identifier: Apache-2.0
// The keys of scene files. One table serves the reader, its hints and the documentation.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/description.hpp"
#include "scene/part_options.hpp"

namespace epura::scene {

/// The content of a scene file before its parts are resolved.
struct SceneWords {
  SceneDescription description;
  std::vector<DimensionWords> dimensions;
  std::vector<ThreadWords> threads;
  std::vector<CalloutWords> callouts;
  std::vector<RequirementWords> requirements;
  std::vector<AcceptedWords> accepted;
  SheetDescription every_sheet;
};

/// Throws Error{input} for unknown keys, missing keys and invalid values.
SceneWords read_scene_words(const TomlValue& file);

/// A section of scene files.
struct SceneSection {
  std::string name;  ///< "model"
  std::vector<OptionInfo> keys;
  bool is_list;  ///< [[model]], of which there may be several
};

/// All sections, in the order of the documentation.
std::vector<SceneSection> scene_sections();

/// Returns a table in Markdown with the keys of all sections: section, key, value, default, meaning.
std::string describe_scene_keys();

}  // namespace epura::scene
