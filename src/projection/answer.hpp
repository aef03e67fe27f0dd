// SPDX-License-Identifier: Apache-2.0
// What a plugin answers to values, what may be wrong with the answer, and the projection that it is.
#pragma once

#include <epura/projection_abi.h>

#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "projection/catalogue.hpp"

namespace epura::projection {

/// A plugin's answer to values.
struct PluginAnswer {
  epura_view view;
  std::optional<std::string> refusal;  ///< the sentence by which the plugin refuses the values; `view` is then nothing
};

/// Calls the plugin, here and now: an AskProjection for libraries that this process has loaded. An exception that
/// crosses the border and arithmetic that is not what it was are errors.
PluginAnswer call_plugin(const epura_projection& definition, const std::vector<double>& values, const Box& scene);

/// Asks for a projection. `scene` is the box of everything. Throws Error{plugin} naming the library.
PluginAnswer ask_plugin(const ProjectionEntry& entry, const ParameterValues& values, const Box& scene);

/// What keeps an answer from being a projection, each a sentence, or empty if nothing does. To be asked in this order:
/// the latter two take it for granted that numbers are finite.
std::string fault_of_numbers(const epura_view& view);  ///< one is not finite
std::string fault_of_plane(const epura_view& view);    ///< plane, up and projectors depend on each other
std::string fault_of_picture(const epura_view& view);  ///< scale, window and limits leave nothing to draw

/// The first fault of the three.
std::string fault_of(const epura_view& view);

/// Of an answer without fault: all but its name and values.
Projection projection_of(const epura_view& view);

}  // namespace epura::projection
