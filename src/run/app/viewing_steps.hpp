// SPDX-License-Identifier: Apache-2.0
// The steps of a projection, from the world to the viewport: of `epura plugins NAME --model MODEL` and `epura serve`.
#pragma once

#include <string>

#include "app/options.hpp"
#include "projection/catalogue.hpp"
#include "view/viewing_model.hpp"

namespace epura {

/// Prints the viewing model and, if asked for, the way of a vertex. Returns the exit code. Throws Error.
int show_steps(const projection::ProjectionEntry& entry, const scene::ProjectionRequest& request,
               const PluginsOptions& options);

/// The numbers and matrices of a view as JSON; `more` are further members, each after a comma.
std::string viewing_json(const projection::Projection& projection, const view::ViewingModel& model,
                         const std::string& more = {});

}  // namespace epura
