// SPDX-License-Identifier: Apache-2.0
// The options of all commands but `draw`.
#pragma once

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

Options<CompareOptions> compare_options();
Options<SnapshotOptions> snapshot_options();
Options<InfoOptions> info_options();
Options<PluginsOptions> plugins_options();
Options<CheckPluginOptions> check_plugin_options();
Options<NewProjectionOptions> new_projection_options();

}  // namespace epura
