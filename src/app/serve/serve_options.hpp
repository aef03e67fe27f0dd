// SPDX-License-Identifier: Apache-2.0
// The options of `epura serve`: those of drawings with one view of whole models, and its own.
#pragma once

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

scene::Options<ServeOptions> serve_options();

}  // namespace epura
