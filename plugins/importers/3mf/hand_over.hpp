// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epura/importer_plugin.hpp>

#include "model.hpp"

namespace epura::plugin::threemf {

/// Passes to the sink what the model builds, or all of it if it builds nothing; each shape once. What is no part of the
/// object that is printed is left out and counted in a note.
void hand_over(const Model& model, Sink& sink);

}  // namespace epura::plugin::threemf
