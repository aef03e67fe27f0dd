// SPDX-License-Identifier: Apache-2.0
// epura plugins NAME --model MODEL: the steps of a projection, from the world to the viewport.
#pragma once

#include "app/options.hpp"
#include "projection/catalogue.hpp"

namespace epura {

/// Prints the viewing model and, if asked for, the way of a vertex. Returns the exit code. Throws Error.
int show_steps(const projection::ProjectionEntry& entry, const scene::ProjectionRequest& request,
               const PluginsOptions& options);

}  // namespace epura
