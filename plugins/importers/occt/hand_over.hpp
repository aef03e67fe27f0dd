// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epura/importer_plugin.hpp>

#include "model.hpp"

namespace occt {

/// A tessellated model to the sink: parts, places, notes. `tolerance`: mm between surfaces and triangles.
void hand_over(Model& model, double tolerance, epura::plugin::Sink& sink);

}  // namespace occt
