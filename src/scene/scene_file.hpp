// SPDX-License-Identifier: Apache-2.0
// Scene files: descriptions of drawings in TOML, see docs/formats.md.
#pragma once

#include <filesystem>

#include "scene/description.hpp"

namespace epura::scene {

/// The content of the file, with at least one model and one sheet; model paths are relative to the scene file.
/// Views may be missing; those that are there have names. Throws Error{input} for what cannot be read, unknown keys,
/// values that are not what their key takes, and names that lead nowhere or to two things: with line, column and hint.
SceneDescription read_scene_file(const std::filesystem::path& path);

/// Throws Error{input} for two models, sections or views of one name, for sections that views name and that are not
/// there, and for views on sheets that are not there.
void expect_sound_names(const SceneDescription& scene);

}  // namespace epura::scene
