// SPDX-License-Identifier: Apache-2.0
// The commands. Each returns the exit code.
#pragma once

#include "app/options.hpp"

namespace epura {

/// A test found an error in a drawing or plugin.
inline constexpr int found_wrong_exit_code = 1;
/// The drawing was written, but edges are missing because of --time-limit.
inline constexpr int partial_exit_code = 5;

int draw(const DrawOptions& options);
/// Draws, and reports faults of the dimensions.
int lint(DrawOptions options);
/// Draws, and says in words what the sheets show.
int describe_drawing(DrawOptions options);
/// Draws, and proves that the numbers on the sheets define the part.
int define(DrawOptions options);
int plugins(const PluginsOptions& options);
int picture(const PictureOptions& options);
int check_plugin(const CheckPluginOptions& options);
int importers(const ImportersOptions& options);
int check_importer(const CheckImporterOptions& options);
int new_projection(const NewProjectionOptions& options);
int new_scene(const NewSceneOptions& options);
int info(const InfoOptions& options);
/// Lists what models require. Returns `found_wrong_exit_code` if some requirement could not be read whole.
int requirements(const RequirementsOptions& options);

}  // namespace epura
