// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epura/importer_plugin.hpp>

#include "model.hpp"
#include "tessellation.hpp"

namespace occt {

/// Passes a tessellated model to the sink: parts, instances, notes.
void hand_over(Model& model, const Fineness& fineness, epura::plugin::Sink& sink);

}  // namespace occt
