// SPDX-License-Identifier: Apache-2.0
// Reads scene files: descriptions of drawings in TOML, see docs/scenes.md.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/description.hpp"
#include "scene/toml_tree.hpp"

namespace epura::scene {

/// Whether a scene file may name files that do not lie below its folder.
enum class FilesOutside { refused, allowed };

/// Returns the content of the file, with at least one model and one sheet; paths of models are resolved relative to the
/// scene file. There may be no views; all views have names. Throws Error{input}, with line, column and hint, for files
/// that cannot be read, unknown keys, invalid values, and names that refer to nothing or are not unique.
SceneDescription read_scene_file(const std::filesystem::path& path, FilesOutside outside = FilesOutside::refused);

/// The same for the root table of a file, or of a program that has the same keys. Paths stay as they are.
SceneDescription scene_of(const TomlValue& root);

/// The models, templates, logos, styles and fonts that a scene names.
std::vector<std::filesystem::path> files_named_in(const SceneDescription& scene);

/// Throws Error{input} for two models, sections or views with one name, and for views that refer to sections or sheets
/// that do not exist.
void expect_sound_names(const SceneDescription& scene);

}  // namespace epura::scene
